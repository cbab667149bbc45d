// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PdfWriter.h"

#include "Drawing/PatternStrokes.h"
#include "Formats/PageTexts.h"
#include "Formats/PdfLayers.h"
#include "Formats/PdfPages.h"
#include "Formats/VisualOrder.h"
#include "Outlines/Pattern.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <array>
#include <cairo-pdf.h>
#include <cmath>
#include <exception>
#include <new>
#include <set>

namespace flattening::pattern
{
namespace
{
/// What of a pattern is drawn on its pages.
struct PdfSelection
{
  bool pages = false; ///< frames, crosses and legend, and the pages of tables
  bool texts = false; ///< of the pieces
  std::set<StrokeRole> roles;
};

constexpr std::array<double, 2> tablePaper{ 210.0, 297.0 };
constexpr double tableMargin = 15.0;
constexpr double letters = 3.0;
constexpr double lineFeed = 5.0;
/// Nothing is thrown through cairo, which is C.
cairo_status_t append(void* closure, const unsigned char* data, unsigned int length)
{
  try
  {
    static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  }
  catch (const std::exception&)
  {
    return CAIRO_STATUS_NO_MEMORY;
  }
  return CAIRO_STATUS_SUCCESS;
}

/// A surface of cairo that writes a PDF, and says what it is of.
/// \param pdf gets the file's bytes until it is closed
_cairo_surface* openPdf(const Pattern& pattern, const PagePlan& plan, std::string& pdf)
{
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(
    &append, &pdf, pointsPerMillimetre * plan.paper.x(), pointsPerMillimetre * plan.paper.y());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, pattern.name.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "SurfaceFlattening");
  if (!pattern.date.empty())
  {
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
      (pattern.date + "T" + pattern.time + ":00Z").c_str());
  }
  return surface;
}

/// Writes what is left, which destroys nothing. \return InvalidPattern where something went wrong
Status closePdf(_cairo_surface* surface, _cairo* context)
{
  cairo_surface_finish(surface);
  cairo_status_t status = cairo_status(context);
  status = status == CAIRO_STATUS_SUCCESS ? cairo_surface_status(surface) : status;
  if (status == CAIRO_STATUS_NO_MEMORY)
  {
    throw std::bad_alloc(); // as where a container finds none
  }
  if (status != CAIRO_STATUS_SUCCESS)
  {
    return { StatusCode::InvalidPattern,
      std::string("the PDF cannot be drawn: ") + cairo_status_to_string(status), {},
      { Remedy::WriteOtherFormat } };
  }
  return {};
}

constexpr double mapHeight = 45.0;
constexpr double legendLetters = 2.8;
constexpr std::array<double, 3> blackInk{ 0.0, 0.0, 0.0 };
constexpr std::array<double, 3> grey{ 0.6, 0.6, 0.6 };
constexpr std::array<double, 3> cyan{ 0.0, 0.55, 0.75 };

enum class Anchor
{
  Start,
  Middle,
  End,
};

/// The drawing of one file.
class PdfDrawing
{
public:
  PdfDrawing(const Pattern& pattern, PaperSize paper, const PagePlan& plan,
    const PdfSelection& selection, std::string& pdf)
    : Drawn(pattern)
    , Paper(paper)
    , Plan(plan)
    , Selected(selection)
    , Surface(openPdf(pattern, plan, pdf))
  {
    this->Context = cairo_create(this->Surface);
    cairo_select_font_face(
      this->Context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  }
  ~PdfDrawing()
  {
    cairo_destroy(this->Context);
    cairo_surface_destroy(this->Surface);
  }
  PdfDrawing(const PdfDrawing&) = delete;
  PdfDrawing& operator=(const PdfDrawing&) = delete;

  Status draw()
  {
    for (const PatternPiece& piece : this->Drawn.pieces)
    {
      this->Strokes.push_back(strokesOf(piece));
    }
    for (std::size_t page = 0; page < this->Plan.pages.size(); ++page)
    {
      this->drawPage(page);
      cairo_show_page(this->Context);
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
    return closePdf(this->Surface, this->Context);
  }

private:
  void colour(const std::array<double, 3>& rgb)
  {
    cairo_set_source_rgb(this->Context, rgb[0], rgb[1], rgb[2]);
  }

  void line(const Point2& from, const Point2& to)
  {
    cairo_move_to(this->Context, from.x(), from.y());
    cairo_line_to(this->Context, to.x(), to.y());
    cairo_stroke(this->Context);
  }

  void pen(const std::array<double, 3>& rgb, double width)
  {
    this->colour(rgb);
    cairo_set_line_width(this->Context, width);
    cairo_set_dash(this->Context, nullptr, 0, 0.0);
  }

  /// \param at middle of the text's height
  void text(
    const std::string& words, const Point2& at, double height, Anchor anchor, double angle = 0.0)
  {
    // cairo draws nothing more after broken UTF-8, and one character after the other.
    const std::string content = visualOrder(cleanText(words));
    cairo_set_font_size(this->Context, height);
    cairo_text_extents_t extents;
    cairo_text_extents(this->Context, content.c_str(), &extents);
    const double back = anchor == Anchor::Start ? 0.0
      : anchor == Anchor::Middle                ? extents.x_advance / 2.0
                                                : extents.x_advance;
    cairo_save(this->Context);
    cairo_translate(this->Context, at.x(), at.y());
    cairo_rotate(this->Context, -angle);
    cairo_move_to(this->Context, -back, 0.35 * height);
    cairo_show_text(this->Context, content.c_str());
    cairo_restore(this->Context);
  }

  void drawPage(std::size_t page)
  {
    const Tile& tile = this->Plan.pages[page];
    const Point2& printable = this->Plan.printable;
    this->beginPage();
    cairo_translate(this->Context, pageMargin, pageMargin);

    // Beneath the drawing, whose lines must not vanish under a trim line.
    if (this->Selected.pages && this->Plan.tiled && this->Plan.pages.size() > 1)
    {
      this->drawFrame(page);
    }
    cairo_save(this->Context);
    // Half a line's width beyond, so that a line on the border of the sheet is whole.
    cairo_rectangle(this->Context, -0.3, -0.3, printable.x() + 0.6, printable.y() + 0.6);
    cairo_clip(this->Context);
    cairo_translate(
      this->Context, -tile.column * this->Plan.step.x(), -tile.row * this->Plan.step.y());
    if (this->Selected.pages)
    {
      cairo_save(this->Context);
      cairo_translate(this->Context, this->Plan.origin.x(), this->Plan.origin.y());
      this->drawLegend();
      cairo_restore(this->Context);
    }
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      this->drawStrokes(p);
      if (this->Selected.texts)
      {
        this->drawTexts(p);
      }
    }
    cairo_restore(this->Context);
  }

  void beginPage()
  {
    cairo_identity_matrix(this->Context);
    cairo_scale(this->Context, pointsPerMillimetre, pointsPerMillimetre);
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
    cairo_pdf_surface_set_size(
      this->Surface, pointsPerMillimetre * tablePaper[0], pointsPerMillimetre * tablePaper[1]);
    const double top = tableMargin + 14.0;
    for (std::size_t next = 1; next < table.rows.size();)
    {
      this->beginPage();
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
      cairo_show_page(this->Context);
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
      this->pen(style.colour, style.width);
      int dashes = 0;
      while (dashes < 4 && style.dashes[static_cast<std::size_t>(dashes)] > 0.0)
      {
        ++dashes;
      }
      cairo_set_dash(this->Context, style.dashes.data(), dashes, 0.0);
      this->addPath(p, stroke);
      if (stroke.closed)
      {
        cairo_close_path(this->Context);
      }
      if (stroke.filled)
      {
        cairo_fill_preserve(this->Context);
      }
      cairo_stroke(this->Context);
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
      const Point2 from = at(span.control[0]);
      const Point2 one = at(span.control[1]);
      const Point2 two = at(span.control[2]);
      const Point2 to = at(span.control[3]);
      if (&span == &stroke.smooth.front())
      {
        cairo_move_to(this->Context, from.x(), from.y());
      }
      cairo_curve_to(this->Context, one.x(), one.y(), two.x(), two.y(), to.x(), to.y());
    }
    for (std::size_t k = 0; stroke.smooth.empty() && k < stroke.points.size(); ++k)
    {
      const Point2 q = at(stroke.points[k]);
      (k == 0 ? cairo_move_to : cairo_line_to)(this->Context, q.x(), q.y());
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
    cairo_rectangle(this->Context, 0.0, 0.0, 100.0, 50.0);
    cairo_stroke(this->Context);
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
    cairo_save(this->Context);
    cairo_translate(this->Context, corner.x(), corner.y());
    cairo_scale(this->Context, scale, scale);
    const double pen = 0.15 / scale;
    this->pen(blackInk, pen);
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      for (const Stroke& stroke : this->Strokes[p])
      {
        if (!stroke.closed || stroke.isWire || stroke.filled)
        {
          continue;
        }
        this->addPath(p, stroke);
        cairo_close_path(this->Context);
        cairo_stroke(this->Context);
      }
    }
    this->pen(cyan, pen);
    const double height = std::min(4.0 / scale, 0.3 * this->Plan.step.minCoeff());
    for (const Tile& tile : this->Plan.pages)
    {
      const Point2 low(tile.column * this->Plan.step.x(), tile.row * this->Plan.step.y());
      cairo_rectangle(
        this->Context, low.x(), low.y(), this->Plan.printable.x(), this->Plan.printable.y());
      cairo_stroke(this->Context);
      this->text(tileName(tile), low + this->Plan.printable / 2.0, height, Anchor::Middle);
    }
    cairo_restore(this->Context);
  }

  /// Frame, crosses, and the names of the page and its neighbours.
  void drawFrame(std::size_t page)
  {
    const Tile& tile = this->Plan.pages[page];
    const Point2& size = this->Plan.printable;
    const double half = this->Plan.overlap / 2.0;
    this->pen(grey, 0.15);
    cairo_rectangle(this->Context, 0.0, 0.0, size.x(), size.y());
    cairo_stroke(this->Context);
    // Trim lines run through the crosses, in the middle of the bands that pages share.
    const double arm = std::clamp(half, 2.0, 5.0);
    const auto has = [&](int down, int across) {
      return hasPage(this->Plan, { tile.row + down, tile.column + across });
    };
    for (const int side : { -1, 1 })
    {
      const double x = side < 0 ? half : size.x() - half;
      const double y = side < 0 ? half : size.y() - half;
      this->pen(cyan, 0.15);
      const double dash[] = { 1.0, 2.0 };
      cairo_set_dash(this->Context, dash, 2, 0.0);
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
    this->colour(blackInk);
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
  const PdfSelection& Selected;
  cairo_surface_t* Surface;
  cairo_t* Context = nullptr;
  std::vector<std::vector<Stroke>> Strokes;
};

/// Draws pages by cairo. \param pdf the file's bytes
Status drawPdf(const Pattern& pattern, PaperSize paper, const PagePlan& plan,
  const PdfSelection& selection, std::string& pdf)
{
  return PdfDrawing(pattern, paper, plan, selection, pdf).draw();
}

std::set<StrokeRole> rolesOf(const Pattern& pattern)
{
  std::set<StrokeRole> roles;
  for (const PatternPiece& piece : pattern.pieces)
  {
    for (const Stroke& stroke : strokesOf(piece))
    {
      roles.insert(stroke.role);
    }
  }
  return roles;
}

/// The name of a role's layer, which is that of SVG.
std::string nameOf(StrokeRole role)
{
  std::string name = styleOf(role).name;
  std::replace(name.begin(), name.end(), '-', ' ');
  return name;
}
}

Status makePdf(const Pattern& drawing, const PageOptions& options, std::string& pdf)
{
  pdf.clear();
  PagePlan plan;
  Status status = planPages(drawing, options, plan);
  if (!status.ok())
  {
    return status;
  }
  Pattern pattern = drawing;
  keepTextsOnPages(plan, pattern);
  const std::set<StrokeRole> roles = rolesOf(pattern);
  if (!hasPdfLayers())
  {
    return drawPdf(pattern, options.paper, plan, { true, true, roles }, pdf);
  }
  std::vector<PdfLayer> layers;
  const auto add = [&](const std::string& name, const PdfSelection& selection) {
    if (status.ok())
    {
      layers.push_back({ name, {} });
      status = drawPdf(pattern, options.paper, plan, selection, layers.back().pdf);
    }
  };
  add("page marks", { true, false, {} });
  for (const StrokeRole role : roles)
  {
    add(nameOf(role), { false, false, { role } });
  }
  add("text", { false, true, {} });
  return status.ok() ? joinPdfLayers(layers, plan.pages.size(), pdf) : status;
}
}
