// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathFitting.h"

#include "Base/Memory.h"
#include "Paths/PathDistance.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"
#include "Paths/SurfaceSpline.h"

#include <set>

namespace flattening
{
namespace
{
/// Each round adds nodes where the spline is off; one that still is after these never comes near.
constexpr int maxFittingRounds = 40;

Status checkFit(const TriangleMesh& mesh, const SurfacePath& path, double tolerance)
{
  if (!liesOn(mesh, path) || !(lengthOf(path) > 0.0))
  {
    return { StatusCode::InvalidCurve, "a path to be fitted is not on the surface, or a point", {},
      { Remedy::RedrawCurve } };
  }
  if (!(tolerance > 0.0))
  {
    return { StatusCode::InvalidOption, "the tolerance of a fitted path is not positive", {},
      { { Remedy::Give, "a distance above 0" } } };
  }
  return {};
}

/// The point of a part of a path that is farthest from a line, by its place in the list; none
/// within the tolerance: `first`.
std::size_t farthest(const SurfacePath& path, std::size_t first, std::size_t last,
  const SurfacePath& line, double tolerance)
{
  std::size_t found = first;
  double most = tolerance;
  for (std::size_t i = first + 1; i < last; ++i)
  {
    const double gap = gapInSpace(line, path.points[i].position);
    if (gap > most)
    {
      most = gap;
      found = i;
    }
  }
  return found;
}

bool isClosed(const SurfacePath& path)
{
  return samePlace(path.points.front(), path.points.back());
}

/// Places that a fit starts from: the ends, and thirds of what is closed.
std::vector<std::size_t> firstNodes(const SurfacePath& path)
{
  std::vector<std::size_t> places{ 0 };
  if (isClosed(path))
  {
    const double length = lengthOf(path);
    double done = 0.0;
    for (std::size_t i = 1; i + 1 < path.points.size() && places.size() < 3; ++i)
    {
      done += (path.points[i].position - path.points[i - 1].position).norm();
      if (done >= length * static_cast<double>(places.size()) / 3.0)
      {
        places.push_back(i);
      }
    }
    if (places.size() < 3 && path.points.size() > 3)
    {
      places = { 0, path.points.size() / 3, 2 * path.points.size() / 3 };
    }
  }
  places.push_back(path.points.size() - 1);
  return places;
}

FittedPath failed(Status status)
{
  FittedPath fit;
  fit.status = std::move(status);
  return fit;
}

void takeNodes(const SurfacePath& path, const std::vector<std::size_t>& places, FittedPath& fit)
{
  for (const std::size_t place : places)
  {
    fit.nodes.push_back(path.points[place]);
  }
  if (isClosed(path))
  {
    fit.nodes.pop_back();
  }
}
}

FittedPath fitStraightPaths(const PathGraph& graph, const SurfacePath& path, double tolerance)
{
  return withinMemory([&] {
    FittedPath fit;
    fit.status = checkFit(graph.mesh(), path, tolerance);
    if (!fit.status.ok())
    {
      return fit;
    }
    std::vector<std::size_t> places = firstNodes(path);
    for (std::size_t k = 0; k + 1 < places.size();)
    {
      const std::size_t first = places[k];
      const std::size_t last = places[k + 1];
      StraightPath straight =
        straightPathNear(graph, partOf(path, first, last), path.points[first], path.points[last]);
      if (straight.status.refused())
      {
        return failed(std::move(straight.status));
      }
      const std::size_t divided = farthest(path, first, last, straight.path, tolerance);
      if (divided == first)
      {
        fit.segments.push_back(std::move(straight.path));
        ++k;
      }
      else
      {
        places.insert(places.begin() + static_cast<std::ptrdiff_t>(k + 1), divided);
      }
    }
    takeNodes(path, places, fit);
    return fit;
  });
}

FittedPath fitSpline(
  const PathGraph& graph, const SurfaceLocator& locator, const SurfacePath& path, double tolerance)
{
  return withinMemory([&] {
    FittedPath fit;
    fit.status = checkFit(graph.mesh(), path, tolerance);
    if (!fit.status.ok())
    {
      return fit;
    }
    std::vector<std::size_t> places = firstNodes(path);
    for (int round = 0; round < maxFittingRounds; ++round)
    {
      fit = {};
      takeNodes(path, places, fit);
      const SurfaceSpline spline = surfaceSpline(graph, locator, fit.nodes, isClosed(path));
      if (spline.status.refused())
      {
        return failed(spline.status);
      }
      std::set<std::size_t> next(places.begin(), places.end());
      for (std::size_t k = 0; k + 1 < places.size(); ++k)
      {
        fit.segments.push_back(partOf(spline.path, spline.stations[k], spline.stations[k + 1]));
        next.insert(farthest(path, places[k], places[k + 1], fit.segments.back(), tolerance));
      }
      if (next.size() == places.size())
      {
        return fit;
      }
      places.assign(next.begin(), next.end());
    }
    fit.status = { StatusCode::NotConverged,
      "a smooth curve does not come near enough to the path that it is fitted to" };
    return fit;
  });
}
}
