// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PageDrawing.h"

#include "Outlines/Pattern.h"
#include "Outlines/PatternText.h"
#include "Outlines/PlaneGeometry.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace flattening::pattern
{
namespace
{
constexpr std::array<double, 2> tablePaper{ 210.0, 297.0 };
constexpr double tableMargin = 15.0;
constexpr double letters = 3.0;
constexpr double lineFeed = 5.0;
constexpr double mapHeight = 45.0;
constexpr double legendLetters = 2.8;
constexpr std::array<double, 3> blackInk{ 0.0, 0.0, 0.0 };
constexpr std::array<double, 3> grey{ 0.6, 0.6, 0.6 };
constexpr std::array<double, 3> cyan{ 0.0, 0.55, 0.75 };

struct PageDrawing
{
  void draw()
  {
    for (const PatternPiece& piece : this->Drawn.pieces)
    {
      this->Strokes.push_back(strokesOf(piece));
    }
    for (std::size_t page = 0; page < this->Plan.pages.size(); ++page)
    {
      this->drawPage(page);
      this->Canvas.endPage();
    }
    if (this->Selected.pages)
    {
      if (this->Plan.tiled && this->listedPieces() < this->Drawn.pieces.size())
      {
        this->drawTable(this->listOfPieces());
      }
      for (const PatternTable& table : this->Drawn.tables)
      {
        this->drawTable(table);
      }
    }
  }

  void line(const Point2& from, const Point2& to)
  {
    this->Canvas.moveTo(from);
    this->Canvas.lineTo(to);
    this->Canvas.stroke(false);
  }

  void rectangle(const Point2& corner, const Point2& extent)
  {
    this->Canvas.rectangle(corner, extent);
    this->Canvas.stroke(false);
  }

  void pen(const Color& color, double width, const std::array<double, 4>& dashes = {})
  {
    this->Canvas.pen(color, width, dashes);
  }

  void text(
    const std::string& words, const Point2& at, double height, Anchor anchor, double angle = 0.0)
  {
    this->Canvas.text(cleanText(words), at, height, anchor, angle);
  }

  void drawPage(std::size_t page)
  {
    const Tile& tile = this->Plan.pages[page];
    const Point2& printable = this->Plan.printable;
    this->Canvas.beginPage(this->Plan.paper);
    this->Canvas.translate(Point2::Constant(pageMargin));

    // Beneath the drawing, whose lines must not vanish under a trim line.
    if (this->Selected.pages && this->Plan.tiled && this->Plan.pages.size() > 1)
    {
      this->drawFrame(page);
    }
    this->Canvas.save();
    // Half a line's width beyond, so that a line on the border of the sheet is whole.
    this->Canvas.clip(Point2::Constant(-0.3), printable + Point2::Constant(0.6));
    this->Canvas.translate(-Point2(tile.column, tile.row).cwiseProduct(this->Plan.step));
    if (this->Selected.pages)
    {
      this->Canvas.save();
      this->Canvas.translate(this->Plan.origin);
      this->drawLegend();
      this->Canvas.restore();
    }
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      this->drawStrokes(p);
      if (this->Selected.texts)
      {
        this->drawTexts(p);
      }
    }
    this->Canvas.restore();
  }

  /// Draws a table on as many A4 pages as it takes.
  void drawTable(const PatternTable& table)
  {
    const double width = tablePaper[0] - 2.0 * tableMargin;
    const auto writeRow = [&](const std::vector<std::string>& row, double y) {
      for (std::size_t k = 0; k < row.size(); ++k)
      {
        const double end = k + 1 < row.size() ? table.columns[k + 1] - 1.0 : width;
        this->text(fitText(row[k], letters, end - table.columns[k]),
          { tableMargin + table.columns[k], y - 0.35 * letters }, letters, Anchor::Start);
      }
    };
    const double top = tableMargin + 14.0;
    for (std::size_t next = 1; next < table.rows.size();)
    {
      this->Canvas.beginPage({ tablePaper[0], tablePaper[1] });
      this->pen(blackInk, 0.2);
      this->text(fitText(table.title + ": " + this->Drawn.name, 5.0, width),
        { tableMargin, tableMargin + 3.25 }, 5.0, Anchor::Start);
      writeRow(table.rows.front(), top);
      this->line({ tableMargin, top + 1.5 }, { tablePaper[0] - tableMargin, top + 1.5 });
      for (double y = top + 1.5 * lineFeed;
           y < tablePaper[1] - tableMargin && next < table.rows.size(); y += lineFeed)
      {
        writeRow(table.rows[next++], y);
      }
      this->Canvas.endPage();
    }
  }

  void drawStrokes(std::size_t p)
  {
    for (const Stroke& stroke : this->Strokes[p])
    {
      if (this->Selected.roles.count(stroke.role) == 0)
      {
        continue;
      }
      const StrokeStyle style = styleOf(stroke.role);
      this->pen(style.color, style.width, style.dashes);
      this->addPath(p, stroke);
      if (stroke.closed)
      {
        this->Canvas.closePath();
      }
      this->Canvas.stroke(stroke.filled);
    }
  }

  void drawTexts(std::size_t p)
  {
    this->pen(blackInk, 0.25);
    for (const PatternText& text : this->Drawn.pieces[p].texts)
    {
      this->text(text.text, this->Plan.layout.place(this->Drawn, p, text.position), text.height,
        Anchor::Middle, text.angle);
    }
  }

  void addPath(std::size_t p, const Stroke& stroke)
  {
    const auto at = [&](const Point2& point) {
      return this->Plan.layout.place(this->Drawn, p, point);
    };
    for (const FairSpan& span : stroke.smooth)
    {
      if (&span == &stroke.smooth.front())
      {
        this->Canvas.moveTo(at(span.control[0]));
      }
      this->Canvas.curveTo(at(span.control[1]), at(span.control[2]), at(span.control[3]));
    }
    for (std::size_t k = 0; stroke.smooth.empty() && k < stroke.points.size(); ++k)
    {
      const Point2 q = at(stroke.points[k]);
      k == 0 ? this->Canvas.moveTo(q) : this->Canvas.lineTo(q);
    }
  }

  /// As many as there is room for above the lower edge of the rectangle.
  std::size_t listedPieces() const
  {
    const double head = 4.0 + 9.0 + (this->Plan.pages.size() > 1 ? 3.0 : 1.5) * legendLetters;
    const auto lines = static_cast<std::size_t>((50.0 - head) / (1.5 * legendLetters));
    const std::size_t pieces = this->Drawn.pieces.size();
    return pieces <= lines ? pieces : lines - 1;
  }

  PatternTable listOfPieces() const
  {
    PatternTable list;
    list.title = "Pieces";
    list.columns = { 0.0, 14.0, 104.0, 139.0 };
    list.rows.push_back({ "No.", "Name", "Size", "Cut" });
    for (const PatternPiece& piece : this->Drawn.pieces)
    {
      list.rows.push_back(
        { std::to_string(piece.number), piece.name, piece.size, std::to_string(piece.quantity) });
    }
    return list;
  }

  void drawLegend()
  {
    this->pen(blackInk, 0.25);
    this->rectangle(Point2::Zero(), { 100.0, 50.0 });
    this->text("100 mm x 50 mm", { 50.0, 21.0 }, 4.0, Anchor::Middle);
    this->text("Print at 100 % and measure this rectangle.", { 50.0, 29.0 }, 4.0, Anchor::Middle);
    const double room = legendExtent(false).x() - 103.0;
    constexpr double small = legendLetters;
    double y = 4.0;
    const auto write = [&](const std::string& content, double height) {
      this->text(fitText(content, height, room), { 103.0, y }, height, Anchor::Start);
      y += 1.5 * height;
    };
    write(this->Drawn.name, 6.0);
    write("Scale 1:1. Unit of the surface: " + std::string(unitName(this->Drawn.unit)), small);
    if (this->Plan.pages.size() > 1)
    {
      write(std::to_string(this->Plan.pages.size()) + " pages " + paperName(this->Paper) +
          ": join at the crosses.",
        small);
    }
    for (std::size_t p = 0; p < this->listedPieces(); ++p)
    {
      const PatternPiece& piece = this->Drawn.pieces[p];
      write(std::to_string(piece.number) + ": " + piece.name +
          (piece.size.empty() ? "" : ", size " + piece.size) + ", cut " +
          std::to_string(piece.quantity),
        small);
    }
    if (this->listedPieces() < this->Drawn.pieces.size())
    {
      write(std::to_string(this->Drawn.pieces.size()) + " pieces: see the last pages", small);
    }
    if (this->Plan.hasMap)
    {
      this->drawMap({ 0.0, legendExtent(true).y() - mapHeight });
    }
  }

  /// The sheet in small with its pages.
  void drawMap(const Point2& corner)
  {
    const Point2 sheet((this->Plan.columns - 1) * this->Plan.step.x() + this->Plan.printable.x(),
      (this->Plan.rows - 1) * this->Plan.step.y() + this->Plan.printable.y());
    const double scale = std::min(mapHeight / sheet.y(), legendExtent(true).x() / sheet.x());
    this->Canvas.save();
    this->Canvas.translate(corner);
    this->Canvas.scale(scale);
    const double pen = 0.15 / scale;
    this->pen(blackInk, pen);
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      for (const Stroke& stroke : this->Strokes[p])
      {
        if (!stroke.closed || isWire(stroke.role) || stroke.filled)
        {
          continue;
        }
        this->addPath(p, stroke);
        this->Canvas.closePath();
        this->Canvas.stroke(false);
      }
    }
    this->pen(cyan, pen);
    const double height = std::min(4.0 / scale, 0.3 * this->Plan.step.minCoeff());
    for (const Tile& tile : this->Plan.pages)
    {
      const Point2 low(tile.column * this->Plan.step.x(), tile.row * this->Plan.step.y());
      this->rectangle(low, this->Plan.printable);
      this->text(tileName(tile), low + this->Plan.printable / 2.0, height, Anchor::Middle);
    }
    this->Canvas.restore();
  }

  /// Frame, crosses, and the names of the page and its neighbours.
  void drawFrame(std::size_t page)
  {
    const Tile& tile = this->Plan.pages[page];
    const Point2& size = this->Plan.printable;
    const double half = this->Plan.overlap / 2.0;
    this->pen(grey, 0.15);
    this->rectangle(Point2::Zero(), size);
    // Trim lines run through the crosses, in the middle of the bands that pages share.
    const double arm = std::clamp(half, 2.0, 5.0);
    const auto has = [&](int down, int across) {
      return hasPage(this->Plan, { tile.row + down, tile.column + across });
    };
    for (const int side : { -1, 1 })
    {
      const double x = side < 0 ? half : size.x() - half;
      const double y = side < 0 ? half : size.y() - half;
      this->pen(cyan, 0.15, { 1.0, 2.0, 0.0, 0.0 });
      if (has(0, side))
      {
        this->line({ x, 0.0 }, { x, size.y() });
      }
      if (has(side, 0))
      {
        this->line({ 0.0, y }, { size.x(), y });
      }
    }
    this->pen(cyan, 0.3);
    for (const int across : { -1, 1 })
    {
      for (const int down : { -1, 1 })
      {
        const Point2 at(across < 0 ? half : size.x() - half, down < 0 ? half : size.y() - half);
        if (has(0, across) || has(down, 0) || has(down, across))
        {
          this->line(at - Point2(arm, 0.0), at + Point2(arm, 0.0));
          this->line(at - Point2(0.0, arm), at + Point2(0.0, arm));
        }
      }
    }
    this->pen(blackInk, 0.25);
    const std::string name = tileName(tile);
    this->text(name, { 0.0, -4.0 }, 6.0, Anchor::Start);
    this->text("row " + name.substr(0, name.find_first_of("0123456789")) + ", column " +
        std::to_string(tile.column + 1) + ", page " + std::to_string(page + 1) + " of " +
        std::to_string(this->Plan.pages.size()),
      { 16.0, -3.5 }, 3.0, Anchor::Start);
    this->text(
      fitText(this->Drawn.name, 3.0, 0.4 * size.x()), { size.x(), -3.5 }, 3.0, Anchor::End);
    this->nameNeighbour(tile, 0, 1, { size.x() + 3.5, size.y() / 2.0 }, -0.5 * pi);
    this->nameNeighbour(tile, 0, -1, { -3.5, size.y() / 2.0 }, 0.5 * pi);
    this->nameNeighbour(tile, 1, 0, { size.x() / 2.0, size.y() + 3.5 }, 0.0);
    this->nameNeighbour(tile, -1, 0, { size.x() / 2.0, -3.5 }, 0.0);
  }

  void nameNeighbour(const Tile& tile, int down, int across, const Point2& at, double angle)
  {
    const Tile other{ tile.row + down, tile.column + across };
    if (hasPage(this->Plan, other))
    {
      this->text("to " + tileName(other), at, 3.0, Anchor::Middle, angle);
    }
  }

  const Pattern& Drawn;
  PaperSize Paper;
  const PagePlan& Plan;
  const PageSelection& Selected;
  PageCanvas& Canvas;
  std::vector<std::vector<Stroke>> Strokes{};
};

constexpr double clearance = 1.0; // of texts from the border of a page, mm
constexpr int placesAlong = 12;   // that are tried along each side of a page
constexpr std::size_t mostPages = 6;

/// An upright rectangle around a text.
Box boxOf(const PatternText& text)
{
  const double half = 0.5 * textWidth(text.text, text.height);
  const Point2 along(std::abs(std::cos(text.angle)), std::abs(std::sin(text.angle)));
  const Point2 reach = half * along + 0.5 * text.height * Point2(along.y(), along.x());
  Box box;
  box.extend(text.position - reach);
  box.extend(text.position + reach);
  return box;
}

class PieceTexts
{
public:
  PieceTexts(const PagePlan& plan, const Point2& corner, PatternPiece& piece)
    : Piece(piece)
  {
    const double height = piece.extent.y();
    for (const Tile& tile : plan.pages)
    {
      // Without the strips that it shares with others, on which they are glued to each other.
      const auto strip = [&](int down, int across) {
        bool shared = false;
        for (int k = -1; k <= 1; ++k)
        {
          const Tile other{ tile.row + (down == 0 ? k : down),
            tile.column + (across == 0 ? k : across) };
          shared = shared || hasPage(plan, other);
        }
        return clearance + (shared ? plan.overlap : 0.0);
      };
      const Point2 low = Point2(tile.column * plan.step.x(), tile.row * plan.step.y()) - corner;
      const Point2 high = low + plan.printable - Point2(strip(0, 1), strip(1, 0));
      Box page; // y points up in a piece
      page.extend(Point2(low.x() + strip(0, -1), height - low.y() - strip(-1, 0)));
      page.extend(Point2(high.x(), height - high.y()));
      this->Pages.push_back(page);
    }
    for (const PatternLine& line : piece.lines)
    {
      addSegments(line.points, line.closed, this->Strokes);
      if (isCut(line.kind))
      {
        addSegments(line.points, true, this->Cloth);
      }
    }
    this->Strokes.push_back({ piece.grain.from, piece.grain.to });
  }

  void keep()
  {
    std::vector<std::size_t> title;
    for (std::size_t k = 0; k < this->Piece.texts.size(); ++k)
    {
      const TextRole role = this->Piece.texts[k].role;
      if (role == TextRole::Title || role == TextRole::Label)
      {
        title.push_back(k);
      }
      else
      {
        this->keep({ k });
      }
    }
    this->keep(title);
  }

private:
  void keep(const std::vector<std::size_t>& texts)
  {
    Box box;
    for (const std::size_t k : texts)
    {
      box.extend(boxOf(this->Piece.texts[k]));
    }
    const bool isKept = std::any_of(this->Pages.begin(), this->Pages.end(),
      [&box](const Box& page) { return page.contains(box); });
    if (texts.empty() || isKept)
    {
      return;
    }
    std::pair<int, double> least{ 1 << 30, 0.0 }; // lines and texts that it lies on, and the way
    Point2 best = Point2::Zero();
    for (const Box& page : this->nearestPages(box.center()))
    {
      const Point2 room = page.sizes() - box.sizes();
      const auto tryAt = [&](const Point2& low) {
        const Point2 by = low - box.min();
        const std::pair<int, double> now(this->met(box, by, texts), by.norm());
        if (now < least)
        {
          least = now;
          best = by;
        }
      };
      if (room.minCoeff() < 0.0)
      {
        continue;
      }
      tryAt(box.min().cwiseMax(page.min()).cwiseMin(page.min() + room));
      for (int k = 0; k <= placesAlong * (placesAlong + 2); ++k)
      {
        const Point2 share(k % (placesAlong + 1), std::floor(k / (placesAlong + 1.0)));
        tryAt(page.min() + room.cwiseProduct(share) / placesAlong);
      }
    }
    for (const std::size_t k : texts)
    {
      this->Piece.texts[k].position += best;
    }
  }

  std::vector<Box> nearestPages(const Point2& place) const
  {
    std::vector<Box> pages = this->Pages;
    const auto isNearer = [&place](const Box& a, const Box& b) {
      return (a.center() - place).norm() < (b.center() - place).norm();
    };
    const std::size_t count = std::min(mostPages, pages.size());
    const auto end = pages.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(pages.begin(), end, pages.end(), isNearer);
    pages.resize(count);
    return pages;
  }

  /// How much a box lies on that is moved; beyond the cloth it is worth nothing.
  int met(const Box& box, const Point2& by, const std::vector<std::size_t>& own) const
  {
    const Box moved(box.min() + by, box.max() + by);
    if (!inside(moved.center(), this->Cloth))
    {
      return 1 << 29;
    }
    int count = 0;
    for (const Segment& segment : this->Strokes)
    {
      count += enters(segment.from, segment.to, moved.min(), moved.max()) ? 1 : 0;
    }
    for (std::size_t k = 0; k < this->Piece.texts.size(); ++k)
    {
      const bool apart = !moved.intersects(boxOf(this->Piece.texts[k]));
      count += apart || std::find(own.begin(), own.end(), k) != own.end() ? 0 : 1;
    }
    return count;
  }

  PatternPiece& Piece;
  std::vector<Box> Pages; ///< what they show, in the coordinates of the piece
  Segments Strokes;
  Segments Cloth;
};
}

std::set<LineKind> rolesOf(const Pattern& pattern)
{
  std::set<LineKind> roles;
  for (const PatternPiece& piece : pattern.pieces)
  {
    for (const Stroke& stroke : strokesOf(piece))
    {
      roles.insert(stroke.role);
    }
  }
  return roles;
}

void drawPages(const Pattern& pattern, PaperSize paper, const PagePlan& plan,
  const PageSelection& selection, PageCanvas& canvas)
{
  PageDrawing{ pattern, paper, plan, selection, canvas }.draw();
}

Status drawPages(const Pattern& drawing, const PageOptions& options, PageCanvas& canvas)
{
  PagePlan plan;
  Status status = planPages(drawing, options, plan);
  if (status.ok())
  {
    Pattern pattern = drawing;
    keepTextsOnPages(plan, pattern);
    drawPages(pattern, options.paper, plan, { true, true, rolesOf(pattern) }, canvas);
  }
  return status;
}

void keepTextsOnPages(const PagePlan& plan, Pattern& pattern)
{
  for (std::size_t p = 0; plan.pages.size() > 1 && p < pattern.pieces.size(); ++p)
  {
    PieceTexts(plan, plan.layout.corners[p], pattern.pieces[p]).keep();
  }
}
}
