// SPDX-License-Identifier: BSD-3-Clause
#include "Nesting/NoFitRegion.h"

#include "Outlines/PlaneGeometry.h"

#include <algorithm>
#include <cmath>

namespace flattening::pattern
{
namespace
{
using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

constexpr double stepsPerMillimetre = 100.0;
constexpr double thinning = 0.4; // mm, of outlines, which are widened by as much

cInt units(double millimetres)
{
  return static_cast<cInt>(std::llround(stepsPerMillimetre * millimetres));
}

/// Widths of shapes are rounded up and those of cloth down, so that none lies beyond its edge; what
/// is a whole number but for rounding stays.
cInt stepsOf(double width, bool up)
{
  constexpr double whole = 1e-6;
  const double exact = stepsPerMillimetre * width;
  return static_cast<cInt>(up ? std::ceil(exact - whole) : std::floor(exact + whole));
}

Path moved(const Path& path, const IntPoint& by)
{
  Path result;
  result.reserve(path.size());
  for (const IntPoint& p : path)
  {
    result.emplace_back(p.X + by.X, p.Y + by.Y);
  }
  return result;
}

Path rectangle(const IntPoint& low, const IntPoint& high)
{
  return { low, IntPoint(high.X, low.Y), high, IntPoint(low.X, high.Y) };
}
}

const Paths& NoFitRegion::between(std::size_t fixed, std::size_t moving)
{
  const auto [entry, isNew] = this->NoFit.try_emplace({ fixed, moving });
  if (isNew)
  {
    Path turned;
    for (const IntPoint& p : this->Shapes[moving].outline)
    {
      turned.emplace_back(-p.X, -p.Y);
    }
    Paths sums;
    ClipperLib::MinkowskiSum(this->Shapes[fixed].outline, turned, sums, true);
    for (const Path& sum : sums)
    {
      // Holes are places inside the fixed shape.
      if (ClipperLib::Orientation(sum))
      {
        entry->second.push_back(sum);
      }
    }
  }
  return entry->second;
}

std::size_t NoFitRegion::addShape(const Points2& polygon, double gap)
{
  Shape shape;
  const Point2 extent = boxOf(polygon).max();
  shape.width = stepsOf(extent.x(), true);
  shape.height = units(extent.y());
  Path path;
  for (const Point2& p : simplified(polygon, thinning))
  {
    path.emplace_back(units(p.x()), units(p.y()));
  }
  if (!ClipperLib::Orientation(path))
  {
    ClipperLib::ReversePath(path);
  }
  ClipperLib::ClipperOffset offset(2.0, stepsPerMillimetre * thinning);
  offset.AddPath(path, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  Paths widened;
  offset.Execute(widened, stepsPerMillimetre * (gap / 2.0 + thinning));
  const auto largest = std::max_element(widened.begin(), widened.end(),
    [](const Path& a, const Path& b) { return ClipperLib::Area(a) < ClipperLib::Area(b); });
  shape.outline = largest == widened.end() ? path : *largest;
  this->Shapes.push_back(std::move(shape));
  return this->Shapes.size() - 1;
}

Point2 NoFitRegion::lowest(const std::vector<Placed>& there, std::size_t shape, double width)
{
  const Shape& moving = this->Shapes[shape];
  cInt end = 0;
  ClipperLib::Clipper clipper;
  for (const Placed& placed : there)
  {
    const Shape& fixed = this->Shapes[placed.shape];
    const IntPoint at(units(placed.at.x()), units(placed.at.y()));
    end = std::max(end, at.Y + fixed.height);
    for (const Path& path : this->between(placed.shape, shape))
    {
      clipper.AddPath(moved(path, at), ClipperLib::ptClip, true);
    }
  }
  // The places across may be one alone, which has no area.
  const IntPoint low(-1, -1);
  const IntPoint high(std::max<cInt>(stepsOf(width, false) - moving.width, 0) + 1,
    end + moving.height + units(1000.0));
  clipper.AddPath(rectangle(low, high), ClipperLib::ptSubject, true);
  Paths free;
  clipper.Execute(ClipperLib::ctDifference, free, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  IntPoint best(0, high.Y);
  for (const Path& path : free)
  {
    for (const IntPoint& p : path)
    {
      if (p.Y < best.Y || (p.Y == best.Y && p.X < best.X))
      {
        best = p;
      }
    }
  }
  return Point2(static_cast<double>(std::clamp<cInt>(best.X, 0, high.X - 1)),
           static_cast<double>(std::max<cInt>(best.Y, 0))) /
    stepsPerMillimetre;
}
}
