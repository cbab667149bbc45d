// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PageMarks.h"

#include "Drawing/PatternStrokes.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace pattern
{
namespace
{
PageMarks noMarks(const PagePlan& plan)
{
  return PageMarks(static_cast<std::size_t>(plan.rows) * static_cast<std::size_t>(plan.columns), 0);
}

/// Tiles which a segment enters, by clipping it to the tile's rectangle.
bool enters(const Point2& from, const Point2& to, const Point2& low, const Point2& high)
{
  double first = 0.0;
  double last = 1.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double way = to[axis] - from[axis];
    if (way == 0.0)
    {
      if (from[axis] < low[axis] || from[axis] > high[axis])
      {
        return false;
      }
      continue;
    }
    const double a = (low[axis] - from[axis]) / way;
    const double b = (high[axis] - from[axis]) / way;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last;
}

}

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
        marks[static_cast<std::size_t>(row) * static_cast<std::size_t>(plan.columns) +
          static_cast<std::size_t>(column)] = 1;
      }
    }
  }
}

PageMarks pagesOf(const Pattern& pattern, const PagePlan& plan, std::size_t piece)
{
  PageMarks marks = noMarks(plan);
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

PageMarks pagesOfLegend(const PagePlan& plan)
{
  PageMarks marks = noMarks(plan);
  const Point2 legend = legendExtent(plan.hasMap);
  markSegment(plan, plan.origin, plan.origin + Point2(legend.x(), 0.0), marks);
  markSegment(plan, plan.origin, plan.origin + Point2(0.0, legend.y()), marks);
  return marks;
}
}
}
