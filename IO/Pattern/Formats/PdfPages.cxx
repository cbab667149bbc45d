// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PdfPages.h"

#include "Drawing/PatternStrokes.h"
#include "Outlines/PatternText.h"
#include "Outlines/PlaneGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

namespace flattening::pattern
{
namespace
{
constexpr double largestPage = 5080.0; // 14400 points, the limit of PDF viewers
constexpr double legendGap = 10.0;

Point2 paperExtent(PaperSize paper)
{
  switch (paper)
  {
    case PaperSize::Letter:
      return { 215.9, 279.4 };
    case PaperSize::A3:
      return { 297.0, 420.0 };
    case PaperSize::A0:
      return { 841.0, 1189.0 };
    default:
      return { 210.0, 297.0 };
  }
}

/// The place of a page among the marks.
std::size_t markOf(const PagePlan& plan, int row, int column)
{
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(plan.columns) +
    static_cast<std::size_t>(column);
}

/// Marks the pages of a plan that show a part of a segment of the sheet.
void markSegment(const PagePlan& plan, const Point2& from, const Point2& to, PageMarks& marks)
{
  const auto tileOf = [&plan](double at, int axis, int most, double back) {
    return std::clamp(static_cast<int>(std::floor((at - back) / plan.step[axis])), 0, most - 1);
  };
  const Point2 low = from.cwiseMin(to);
  const Point2 high = from.cwiseMax(to);
  for (int row = tileOf(low.y(), 1, plan.rows, plan.overlap);
       row <= tileOf(high.y(), 1, plan.rows, 0.0); ++row)
  {
    for (int column = tileOf(low.x(), 0, plan.columns, plan.overlap);
         column <= tileOf(high.x(), 0, plan.columns, 0.0); ++column)
    {
      const Point2 corner(column * plan.step.x(), row * plan.step.y());
      if (enters(from, to, corner, corner + plan.printable))
      {
        marks[markOf(plan, row, column)] = 1;
      }
    }
  }
}

PageMarks pagesOfLegend(const PagePlan& plan)
{
  PageMarks marks(markOf(plan, plan.rows, 0), 0);
  const Point2 legend = legendExtent(plan.hasMap);
  markSegment(plan, plan.origin, plan.origin + Point2(legend.x(), 0.0), marks);
  markSegment(plan, plan.origin, plan.origin + Point2(0.0, legend.y()), marks);
  return marks;
}

void findPages(const Pattern& pattern, PagePlan& plan)
{
  PageMarks used = pagesOfLegend(plan);
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
  {
    const PageMarks own = pagesOf(pattern, plan, p);
    std::transform(used.begin(), used.end(), own.begin(), used.begin(), std::bit_or<>());
  }
  plan.pages.clear();
  for (int row = 0; row < plan.rows; ++row)
  {
    for (int column = 0; column < plan.columns; ++column)
    {
      if (used[markOf(plan, row, column)] != 0)
      {
        plan.pages.push_back({ row, column });
      }
    }
  }
}

/// The number of tiles along one axis, as a double because it may be huge.
double tilesAlong(double extent, double step, double overlap)
{
  return std::max(1.0, std::ceil((extent - overlap) / step - 1e-9));
}

std::string metres(const Point2& extent)
{
  return formatNumber(extent.x() / 1000.0, 3) + " m x " + formatNumber(extent.y() / 1000.0, 3) +
    " m";
}

const PatternPiece& largestPiece(const Pattern& pattern)
{
  return *std::max_element(
    pattern.pieces.begin(), pattern.pieces.end(), [](const PatternPiece& a, const PatternPiece& b) {
      return a.extent.maxCoeff() < b.extent.maxCoeff();
    });
}

Status tooLarge(const Pattern& pattern, const std::string& reason, Remedy remedy)
{
  const PatternPiece& piece = largestPiece(pattern);
  return { StatusCode::PatternTooLarge,
    "the largest piece, " + piece.name + ", measures " + metres(piece.extent) + " if the unit is " +
      unitName(pattern.unit) + ": " + reason,
    {}, { Remedy::CheckUnit, remedy } };
}

/// A plan for one way to hold the paper and one number of columns to fill.
PagePlan planFor(const Pattern& pattern, const PageOptions& options, const Point2& paper,
  double columns, bool withMap)
{
  PagePlan plan;
  plan.paper = paper;
  plan.overlap = options.overlap;
  plan.hasMap = withMap;
  plan.printable = paper - Point2::Constant(2.0 * pageMargin);
  plan.step = plan.printable - Point2::Constant(options.overlap);
  const double width = columns * plan.step.x() + plan.overlap;
  // The outer bands stay free, so that the legend keeps clear of the crosses.
  plan.origin = Point2::Constant(options.overlap);
  plan.layout = layOut(pattern, width - options.overlap, legendExtent(withMap).y() + legendGap);
  plan.layout.extent = plan.layout.extent.cwiseMax(legendExtent(withMap)) + plan.origin;
  for (Point2& corner : plan.layout.corners)
  {
    corner += plan.origin;
  }
  return plan;
}

/// Packs pieces into pages, on shelves from the top, in the order of their heights.
class PageShelves
{
public:
  /// \param first what is taken from the top of the first page
  PageShelves(const PagePlan& plan, int columns, double first)
    : Step(plan.step)
    , Band(plan.overlap)
    , Room(roomOf(plan))
    , Columns(columns)
  {
    this->Pages.push_back({ first, 0.0, this->Room.x() + 1.0 });
  }

  /// What a page shows and its neighbors do not.
  static Point2 roomOf(const PagePlan& plan) { return plan.step - Point2::Constant(plan.overlap); }

  static bool fits(const PagePlan& plan, const PatternPiece& piece)
  {
    return (roomOf(plan) - piece.extent).minCoeff() >= 0.0;
  }

  /// The upper left corner of a piece that fits.
  Point2 place(const Point2& extent)
  {
    for (std::size_t page = 0;; ++page)
    {
      if (page == this->Pages.size())
      {
        this->Pages.push_back({ 0.0, 0.0, 0.0 });
      }
      Page& shelf = this->Pages[page];
      const bool beside = shelf.x + extent.x() <= this->Room.x() && extent.y() <= shelf.height;
      const double below = shelf.height > 0.0 ? shelf.top + shelf.height + pieceGap : shelf.top;
      if (!beside && below + extent.y() > this->Room.y())
      {
        continue;
      }
      if (!beside)
      {
        shelf = { below, extent.y(), 0.0 };
      }
      const Point2 within(shelf.x, shelf.top);
      shelf.x += extent.x() + pieceGap;
      return this->corner(page) + within;
    }
  }

  /// The first row of pages below.
  double end() const
  {
    return this->corner(this->Pages.size() + static_cast<std::size_t>(this->Columns) - 1).y();
  }

private:
  struct Page
  {
    double top; ///< of its last shelf
    double height;
    double x; ///< where there is room on it
  };

  Point2 corner(std::size_t page) const
  {
    const std::size_t columns = static_cast<std::size_t>(this->Columns);
    const std::size_t row = page / columns;
    const Point2 tile(static_cast<double>(page % columns), static_cast<double>(row));
    return tile.cwiseProduct(this->Step) + Point2::Constant(this->Band);
  }

  Point2 Step;
  double Band;
  Point2 Room;
  int Columns;
  std::vector<Page> Pages;
};

/// The pieces, the highest first.
std::vector<std::size_t> byHeight(const Pattern& pattern)
{
  std::vector<std::size_t> order(pattern.pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(), [&pattern](std::size_t a, std::size_t b) {
    return pattern.pieces[a].extent.y() > pattern.pieces[b].extent.y();
  });
  return order;
}

/// The same plan with each piece that fits a page on one, and the others in rows below them.
PagePlan byPages(const Pattern& pattern, PagePlan plan, int columns)
{
  const std::vector<std::size_t> order = byHeight(pattern);
  PageShelves shelves(plan, columns, legendExtent(plan.hasMap).y() + legendGap);
  for (const std::size_t p : order)
  {
    if (PageShelves::fits(plan, pattern.pieces[p]))
    {
      plan.layout.corners[p] = shelves.place(pattern.pieces[p].extent);
    }
  }
  const double right = plan.origin.x() + columns * plan.step.x() - plan.overlap;
  Point2 at(plan.origin.x(), shelves.end());
  double rowHeight = 0.0;
  plan.layout.extent = plan.origin + legendExtent(plan.hasMap);
  for (const std::size_t p : order)
  {
    const Point2& extent = pattern.pieces[p].extent;
    if (!PageShelves::fits(plan, pattern.pieces[p]))
    {
      if (at.x() > plan.origin.x() && at.x() + extent.x() > right)
      {
        at = Point2(plan.origin.x(), at.y() + rowHeight + pieceGap);
        rowHeight = 0.0;
      }
      plan.layout.corners[p] = at;
      at.x() += extent.x() + pieceGap;
      rowHeight = std::max(rowHeight, extent.y());
    }
    plan.layout.extent = plan.layout.extent.cwiseMax(plan.layout.corners[p] + extent);
  }
  return plan;
}

/// Pieces that fit a page and lie on several.
int splitPieces(const Pattern& pattern, const PagePlan& plan)
{
  int split = 0;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
  {
    if (PageShelves::fits(plan, pattern.pieces[p]))
    {
      const PageMarks marks = pagesOf(pattern, plan, p);
      split += std::accumulate(marks.begin(), marks.end(), 0) > 1 ? 1 : 0;
    }
  }
  return split;
}

/// The pages of a plan, and how far it is from a square, which is easier to lay out and to read as
/// a map.
std::pair<std::size_t, double> costOf(const PagePlan& plan)
{
  return { plan.pages.size(),
    std::abs(std::log(plan.columns * plan.step.x() / (plan.rows * plan.step.y()))) };
}

void planSheet(const Pattern& pattern, PagePlan& plan)
{
  plan = PagePlan();
  plan.tiled = false;
  plan.layout = layOut(pattern, squareWidth(pattern), legendExtent(false).y() + legendGap);
  plan.layout.extent = plan.layout.extent.cwiseMax(legendExtent(false));
  plan.printable = plan.step = plan.layout.extent;
  plan.paper = plan.printable + Point2::Constant(2.0 * pageMargin);
  plan.pages = { Tile() };
}

/// Divides a sheet that is larger than a page of a PDF can be into such pages, to be joined.
Status divideSheet(const Pattern& pattern, const PageOptions& options, PagePlan& plan)
{
  const Point2 whole = plan.paper;
  const Point2 paper = whole.cwiseMin(Point2::Constant(largestPage));
  const Point2 step = paper - Point2::Constant(2.0 * pageMargin + options.overlap);
  const double columns = tilesAlong(whole.x(), step.x(), options.overlap);
  const double rows = tilesAlong(whole.y(), step.y(), options.overlap);
  if (!(columns * rows <= options.maximumPages))
  {
    return tooLarge(pattern,
      "the page would measure " + metres(whole) + ", PDF ends at 5.08 m, and more than " +
        std::to_string(options.maximumPages) + " pages are needed",
      Remedy::PrintOnPages);
  }
  plan = planFor(pattern, options, paper, columns, true);
  plan.columns =
    static_cast<int>(tilesAlong(plan.layout.extent.x(), plan.step.x(), options.overlap));
  plan.rows = static_cast<int>(tilesAlong(plan.layout.extent.y(), plan.step.y(), options.overlap));
  findPages(pattern, plan);
  return {};
}

constexpr int placesOfSide = 9; ///< that are tried along each side of a page
constexpr int sweeps = 2;

/// Where a piece lies on the sheet.
Box laidBox(const Pattern& pattern, const PagePlan& plan, std::size_t piece)
{
  const Point2& corner = plan.layout.corners[piece];
  return { corner, corner + pattern.pieces[piece].extent };
}

/// Whether a piece lies on the sheet, and apart from the others and the legend.
bool isFree(const Pattern& pattern, const PagePlan& plan, std::size_t piece)
{
  const Box sheet(Eigen::Vector2d::Zero(),
    Point2(plan.columns * plan.step.x(), plan.rows * plan.step.y()) +
      Point2::Constant(plan.overlap));
  const Box legend(plan.origin, plan.origin + legendExtent(plan.hasMap));
  const Box box = laidBox(pattern, plan, piece);
  const Box around(
    box.min() - Point2::Constant(pieceGap - 1e-9), box.max() + Point2::Constant(pieceGap - 1e-9));
  bool free = sheet.contains(box) && !around.intersects(legend);
  for (std::size_t q = 0; free && q < pattern.pieces.size(); ++q)
  {
    free = q == piece || !around.intersects(laidBox(pattern, plan, q));
  }
  return free;
}

/// Pages that one piece alone needs, and all that it is on, which counts where those are equal.
/// \param count by page, of what else is on it
std::pair<int, int> costOf(const PageMarks& marks, const std::vector<int>& count)
{
  std::pair<int, int> result{ 0, 0 };
  for (std::size_t k = 0; k < marks.size(); ++k)
  {
    result.first += marks[k] != 0 && count[k] == 0 ? 1 : 0;
    result.second += marks[k];
  }
  return result;
}

/// Tries places all over the sheet for a piece. \param marks its pages
void shift(const Pattern& pattern, std::size_t piece, const std::vector<int>& count, PagePlan& plan,
  PageMarks& marks)
{
  Point2& corner = plan.layout.corners[piece];
  Point2 best = corner;
  std::pair<int, int> least = costOf(marks, count);
  const Point2 by = plan.step / (placesOfSide - 1);
  const bool onePage = PageShelves::fits(plan, pattern.pieces[piece]);
  for (int y = 0; y < (placesOfSide - 1) * plan.rows; ++y)
  {
    for (int x = 0; x < (placesOfSide - 1) * plan.columns; ++x)
    {
      // From where the first page's outer band ends.
      corner = plan.origin + Point2(x * by.x(), y * by.y());
      if (!isFree(pattern, plan, piece))
      {
        continue;
      }
      PageMarks next = pagesOf(pattern, plan, piece);
      const std::pair<int, int> cost = costOf(next, count);
      if (cost < least && (cost.second == 1 || !onePage))
      {
        least = cost;
        best = corner;
        marks = std::move(next);
      }
    }
  }
  corner = best;
}

/// Moves pieces within the free space around them, as far apart as they were laid at least, where
/// fewer pages then show something. Neither pieces laid on cloth nor the sheet change.
void saveByShifts(const Pattern& pattern, PagePlan& plan)
{
  if (pattern.fabric)
  {
    return;
  }
  const PageMarks legend = pagesOfLegend(plan);
  std::vector<int> count(legend.begin(), legend.end()); // by page, of pieces and the legend
  const auto add = [&count](const PageMarks& marks, int by) {
    for (std::size_t k = 0; k < count.size(); ++k)
    {
      count[k] += by * marks[k];
    }
  };
  std::vector<PageMarks> marks;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
  {
    marks.push_back(pagesOf(pattern, plan, p));
    add(marks[p], 1);
  }
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    {
      add(marks[p], -1);
      shift(pattern, p, count, plan, marks[p]);
      add(marks[p], 1);
    }
  }
}
}

const char* paperName(PaperSize paper)
{
  static const char* const names[] = { "A4", "Letter", "A3", "A0", "Sheet" };
  return names[static_cast<int>(paper)];
}

Point2 legendExtent(bool withMap)
{
  // On A4 no wider than what the next page does not show as well.
  return { 169.5, withMap ? 105.0 : 50.0 };
}

std::string tileName(const Tile& tile)
{
  std::string rowName;
  for (int row = tile.row; row >= 0; row = row / 26 - 1)
  {
    rowName.insert(rowName.begin(), static_cast<char>('A' + row % 26));
  }
  return rowName + std::to_string(tile.column + 1);
}

bool hasPage(const PagePlan& plan, const Tile& tile)
{
  return std::any_of(plan.pages.begin(), plan.pages.end(),
    [&tile](const Tile& page) { return page.row == tile.row && page.column == tile.column; });
}

Status checkPages(double area, const PageOptions& options)
{
  const Point2 printable = paperExtent(options.paper) - Point2::Constant(2.0 * pageMargin);
  const double fewest = std::ceil(area / printable.prod());
  if (options.paper == PaperSize::Sheet || fewest <= options.maximumPages)
  {
    return {};
  }
  return { StatusCode::PatternTooLarge,
    "the pattern would need at least " + formatNumber(fewest, 0) + " pages " +
      paperName(options.paper) + ", more than " + std::to_string(options.maximumPages),
    {}, { Remedy::CheckUnit, Remedy::TakeLargerPaper } };
}

PageMarks pagesOf(const Pattern& pattern, const PagePlan& plan, std::size_t piece)
{
  PageMarks marks(markOf(plan, plan.rows, 0), 0);
  for (const Stroke& stroke : strokesOf(pattern.pieces[piece]))
  {
    const std::size_t count = stroke.points.size();
    for (std::size_t k = 0; k + (stroke.closed ? 0 : 1) < count; ++k)
    {
      markSegment(plan, plan.layout.place(pattern, piece, stroke.points[k]),
        plan.layout.place(pattern, piece, stroke.points[(k + 1) % count]), marks);
    }
  }
  return marks;
}

Status planPages(const Pattern& pattern, const PageOptions& options, PagePlan& plan)
{
  if (options.paper == PaperSize::Sheet)
  {
    planSheet(pattern, plan);
    return plan.paper.maxCoeff() > largestPage ? divideSheet(pattern, options, plan) : Status();
  }
  const Point2 upright = paperExtent(options.paper);
  double widest = 0.0;
  for (const PatternPiece& piece : pattern.pieces)
  {
    widest = std::max(widest, piece.extent.x());
  }
  double fewest = 1e300;
  std::array<std::optional<PagePlan>, 2> best; // in rows, and by pages
  const auto consider = [&](PagePlan next, std::optional<PagePlan>& least) {
    const bool withMap = next.hasMap;
    const double across = tilesAlong(next.layout.extent.x(), next.step.x(), options.overlap);
    const double down = tilesAlong(next.layout.extent.y(), next.step.y(), options.overlap);
    // Blank pages are left out, but hardly more than nine in ten.
    if (!(across * down <= 10.0 * options.maximumPages))
    {
      fewest = std::min(fewest, across * down);
      return;
    }
    next.columns = static_cast<int>(across);
    next.rows = static_cast<int>(down);
    findPages(pattern, next);
    const double pages = static_cast<double>(next.pages.size());
    // The map is for those that have pages to join.
    if (withMap != (pages > 1.0) || pages > options.maximumPages)
    {
      fewest = withMap == (pages > 1.0) ? std::min(fewest, pages) : fewest;
      return;
    }
    if (!least || costOf(next) < costOf(*least))
    {
      least = std::move(next);
    }
  };
  for (const bool withMap : { false, true })
  {
    for (const bool landscape : { false, true })
    {
      const Point2 paper = landscape ? Point2(upright.y(), upright.x()) : upright;
      const double step = paper.x() - 2.0 * pageMargin - options.overlap;
      const double first = tilesAlong(widest + options.overlap, step, options.overlap);
      const double last =
        std::max(first, tilesAlong(squareWidth(pattern) * 2.0, step, options.overlap));
      // Counted apart: adding one to a huge number leaves it as it is.
      for (int more = 0; more < 12 && first + more <= last; ++more)
      {
        const PagePlan rows = planFor(pattern, options, paper, first + more, withMap);
        consider(rows, best[0]);
        const bool hasRoom = (PageShelves::roomOf(rows) - legendExtent(withMap)).minCoeff() >= 0.0;
        if (!pattern.fabric && hasRoom && first + more <= 10.0 * options.maximumPages)
        {
          consider(byPages(pattern, rows, static_cast<int>(first) + more), best[1]);
        }
      }
    }
  }
  if (!best[0] && !best[1])
  {
    return tooLarge(pattern,
      "the pattern would need about " + formatNumber(fewest, 0) + " pages " +
        paperName(options.paper) + ", more than " + std::to_string(options.maximumPages),
      Remedy::TakeLargerPaper);
  }
  std::pair<int, std::size_t> least; // pieces that are split for no need, and pages
  bool found = false;
  for (std::optional<PagePlan>& one : best)
  {
    if (one && one->pages.size() > 1)
    {
      saveByShifts(pattern, *one);
      findPages(pattern, *one);
    }
    const std::pair<int, std::size_t> cost =
      one ? std::pair(splitPieces(pattern, *one), one->pages.size()) : least;
    if (one && (!found || cost < least))
    {
      least = cost;
      plan = std::move(*one);
      found = true;
    }
  }
  return {};
}
}
