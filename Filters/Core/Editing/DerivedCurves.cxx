// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/DerivedCurves.h"

#include "Base/Memory.h"
#include "Paths/PathFitting.h"
#include "Paths/PathOffset.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// How far a fitted offset may be off, of the distance: 0.03 mm of a seam allowance of 10 mm, less
/// than cutting by hand or laser is off.
constexpr double ofDistance = 3e-3;
/// Of its length: what is left of a tight curve is rounding.
constexpr double ofTightCurve = 1e-9;
/// Times the tolerance: a hand that means to close a loop misses its start by more than that.
constexpr double closingGap = 3.0;

EditedCurve curveOf(FittedPath fit, SegmentKind kind)
{
  EditedCurve curve;
  curve.closed = fit.segments.size() == fit.nodes.size();
  curve.kinds.assign(fit.segments.size(), kind);
  curve.nodes = std::move(fit.nodes);
  curve.segments = std::move(fit.segments);
  return curve;
}

/// Smooth where a spline comes near enough.
FittedPath fitted(
  const DrawingSurface& surface, const SurfacePath& path, double tolerance, SegmentKind& kind)
{
  if (kind == SegmentKind::Spline)
  {
    FittedPath fit = fitSpline(surface.graph(), surface.locator(), path, tolerance);
    if (fit.status.ok())
    {
      return fit;
    }
  }
  kind = SegmentKind::Geodesic;
  return fitStraightPaths(surface.graph(), path, tolerance);
}
}

DerivedCurves offsetCurves(const DrawingSurface& surface, const EditedCurve& curve, double distance)
{
  return withinMemory([&] {
    DerivedCurves derived;
    PathOffset offset = offsetPath(surface.graph(), wholePath(curve), distance);
    derived.status = std::move(offset.status);
    const bool smooth = std::count(curve.kinds.begin(), curve.kinds.end(), SegmentKind::Spline) > 0;
    for (const SurfacePath& part : offset.parts)
    {
      SegmentKind kind = smooth ? SegmentKind::Spline : SegmentKind::Geodesic;
      FittedPath fit = fitted(surface, part, ofDistance * std::abs(distance), kind);
      if (fit.status.refused())
      {
        derived.status = std::move(fit.status);
        return derived;
      }
      EditedCurve next = curveOf(std::move(fit), kind);
      next.traits = curve.traits;
      next.traits.name += " offset";
      derived.curves.push_back(std::move(next));
    }
    return derived;
  });
}

DerivedCurves tightCurve(const DrawingSurface& surface, const EditedCurve& curve)
{
  return withinMemory([&] {
    DerivedCurves derived;
    if (!curve.closed)
    {
      derived.status = { StatusCode::InvalidOption,
        "curve '" + curve.traits.name + "' is open; only a closed one can be pulled tight", {},
        { { Remedy::Give, "a closed curve" } } };
      return derived;
    }
    const StraightPath loop = straightLoop(surface.graph(), wholePath(curve));
    derived.status = loop.status;
    if (derived.status.refused())
    {
      return derived;
    }
    FittedPath fit = fitStraightPaths(surface.graph(), loop.path, ofTightCurve * loop.length);
    if (fit.status.refused())
    {
      derived.status = std::move(fit.status);
      return derived;
    }
    derived.curves.push_back(curveOf(std::move(fit), SegmentKind::Geodesic));
    derived.curves.back().traits = curve.traits;
    return derived;
  });
}

DerivedCurves strokeCurve(const DrawingSurface& surface, const std::vector<SurfacePoint>& stroke,
  double tolerance, SegmentKind kind)
{
  return withinMemory([&] {
    DerivedCurves derived;
    if (!(tolerance > 0.0))
    {
      derived.status = { StatusCode::InvalidOption,
        "the tolerance of a stroke is " + shortNumber(tolerance) + ", which is not above 0" };
      return derived;
    }
    SurfacePath path;
    for (const SurfacePoint& point : stroke)
    {
      if (path.points.empty())
      {
        path.points = { point };
      }
      else if (!samePlace(path.points.back(), point))
      {
        StraightPath step = localStraightPath(surface.graph(), path.points.back(), point);
        if (step.status.refused())
        {
          derived.status = std::move(step.status);
          return derived;
        }
        append(path, step.path);
      }
    }
    const double length = lengthOf(path);
    if (!(length > tolerance))
    {
      derived.status = { StatusCode::CurveTooShort, "a stroke is not longer than its tolerance", {},
        { Remedy::RedrawCurve } };
      return derived;
    }
    if (!samePlace(path.points.front(), path.points.back()) &&
      (path.points.front().position - path.points.back().position).norm() <=
        closingGap * tolerance &&
      length > 4.0 * closingGap * tolerance)
    {
      append(
        path, localStraightPath(surface.graph(), path.points.back(), path.points.front()).path);
    }
    FittedPath fit = fitted(surface, path, tolerance, kind);
    derived.status = std::move(fit.status);
    if (!derived.status.refused())
    {
      kind = fit.nodes.size() == 2 ? SegmentKind::Geodesic : kind;
      derived.curves.push_back(curveOf(std::move(fit), kind));
    }
    return derived;
  });
}
}
