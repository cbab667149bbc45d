// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/SurfaceSpline.h"

#include "Base/Memory.h"
#include "Paths/PathPoints.h"

#include <cmath>

namespace flattening
{
namespace
{
/// A new point that is farther along the surface than this many times its way in space lies on
/// another sheet.
constexpr double longestWay = 4.0;

/// Weights of four points at places of a line for the value at another place, by Lagrange; those
/// that are not there have none.
std::array<double, 4> lagrangeWeights(
  const std::array<double, 4>& places, const std::array<bool, 4>& there, double at)
{
  std::array<double, 4> weights{};
  for (std::size_t i = 0; i < 4; ++i)
  {
    weights[i] = there[i] ? 1.0 : 0.0;
    for (std::size_t j = 0; j < 4 && there[i]; ++j)
    {
      weights[i] *= j != i && there[j] ? (at - places[j]) / (places[i] - places[j]) : 1.0;
    }
  }
  return weights;
}

class Subdivision
{
public:
  Subdivision(const PathGraph& graph, const SurfaceLocator& locator,
    const std::vector<SurfacePoint>& points, bool closed)
    : Graph(graph)
    , Locator(locator)
    , Points(points)
    , Closed(closed)
  {
    if (closed)
    {
      this->Points.push_back(points.front());
    }
    for (std::size_t k = 0; k < this->Points.size(); ++k)
    {
      this->Stations.push_back(k);
    }
    for (std::size_t k = 0; k + 1 < this->Points.size(); ++k)
    {
      this->Segments.push_back(
        this->joined(straightPath(graph, this->Points[k], this->Points[k + 1])));
    }
  }

  SurfaceSpline run(int rounds)
  {
    for (int k = 0; k < rounds && !this->State.refused() && this->Points.size() > 2; ++k)
    {
      this->refine();
    }
    SurfaceSpline spline;
    spline.status = this->State;
    if (this->State.refused())
    {
      return spline;
    }
    std::size_t station = 0;
    for (std::size_t k = 0; k < this->Points.size(); ++k)
    {
      if (k == 0)
      {
        spline.path.points = { this->Points[0] };
      }
      else
      {
        append(spline.path, this->Segments[k - 1].path);
      }
      if (station < this->Stations.size() && this->Stations[station] == k)
      {
        spline.stations.push_back(spline.path.points.size() - 1);
        ++station;
      }
    }
    spline.path.arrived = true;
    spline.length = lengthOf(spline.path);
    return spline;
  }

private:
  /// The first path that is not straight is named; one that is missing ends the curve.
  StraightPath joined(StraightPath path)
  {
    if (!this->State.refused() && !path.status.ok() && (this->State.ok() || path.status.refused()))
    {
      this->State = path.status;
    }
    return path;
  }

  /// Segment k and its neighbours as steps of the parameter; 0 where there is none.
  double step(std::ptrdiff_t k) const
  {
    const auto count = static_cast<std::ptrdiff_t>(this->Segments.size());
    if (this->Closed)
    {
      k = (k + count) % count;
    }
    return k < 0 || k >= count ? 0.0 : std::sqrt(this->Segments[k].length);
  }

  SurfacePoint pointAt(std::ptrdiff_t k) const
  {
    // The last point of a closed curve is its first.
    const auto count = static_cast<std::ptrdiff_t>(this->Segments.size());
    return this->Points[this->Closed ? (k + count) % count : k];
  }

  /// The point half-way of segment k: of the cubic polynomial through four points, or of the
  /// quadratic one through three at an end of the curve.
  SurfacePoint between(std::ptrdiff_t k)
  {
    const TriangleMesh& mesh = this->Graph.mesh();
    const StraightPath& segment = this->Segments[k];
    const double here = this->step(k);
    const double before = this->step(k - 1);
    const double after = this->step(k + 1);
    if (!(here > 0.0))
    {
      return this->Points[k];
    }
    const std::array<double, 4> weights = lagrangeWeights(
      { -before, 0.0, here, here + after }, { before > 0.0, true, true, after > 0.0 }, 0.5 * here);
    const double inner = weights[1] + weights[2];
    SurfacePoint middle = pointAlong(mesh, segment.path, segment.length * weights[2] / inner);
    if (!(inner > 1.0))
    {
      return middle;
    }
    SurfacePoint outer = this->pointAt(before > 0.0 ? k - 1 : k + 2);
    if (before > 0.0 && after > 0.0)
    {
      const StraightPath across =
        this->joined(localStraightPath(this->Graph, outer, this->pointAt(k + 2)));
      if (across.status.refused())
      {
        return middle;
      }
      outer = pointAlong(mesh, across.path, across.length * weights[3] / (1.0 - inner));
    }
    const Point3 way = (inner - 1.0) * (middle.position - outer.position);
    const ClosestPoint closest = this->Locator.closest(middle.position + way);
    const SurfacePoint moved = pointOf(mesh, closest.triangle, closest.weights);
    return localStraightPath(this->Graph, middle, moved).length <= longestWay * way.norm() ? moved
                                                                                           : middle;
  }

  void refine()
  {
    std::vector<SurfacePoint> points;
    std::vector<StraightPath> segments;
    for (std::size_t k = 0; k < this->Segments.size() && !this->State.refused(); ++k)
    {
      const SurfacePoint& from = this->Points[k];
      const SurfacePoint& to = this->Points[k + 1];
      const SurfacePoint middle = this->between(static_cast<std::ptrdiff_t>(k));
      points.push_back(from);
      points.push_back(middle);
      segments.push_back(this->joined(localStraightPath(this->Graph, from, middle)));
      segments.push_back(this->joined(localStraightPath(this->Graph, middle, to)));
    }
    points.push_back(this->Points.back());
    this->Points = std::move(points);
    this->Segments = std::move(segments);
    for (std::size_t& station : this->Stations)
    {
      station *= 2;
    }
  }

  const PathGraph& Graph;
  const SurfaceLocator& Locator;
  std::vector<SurfacePoint> Points;
  std::vector<StraightPath> Segments; ///< between each two points
  std::vector<std::size_t> Stations;
  bool Closed;
  Status State;
};
}

SurfaceSpline surfaceSpline(const PathGraph& graph, const SurfaceLocator& locator,
  const std::vector<SurfacePoint>& points, bool closed, int rounds)
{
  return withinMemory([&] {
    if (points.size() < (closed ? 3 : 2))
    {
      SurfaceSpline refused;
      refused.status = { StatusCode::CurveTooShort,
        "a spline goes through " + std::string(closed ? "three" : "two") +
          " points at least, not " + std::to_string(points.size()),
        {}, { Remedy::RedrawCurve } };
      return refused;
    }
    return Subdivision(graph, locator, points, closed).run(rounds);
  });
}
}
