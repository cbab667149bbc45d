// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathCrossings.h"

#include "Base/Planar.h"
#include "Paths/PathPoints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace flattening
{
namespace
{
/// How much two legs may miss each other, as a fraction of their lengths.
constexpr double touch = 1e-12;

using Leg = std::pair<std::size_t, std::size_t>; // path, leg

bool areNeighbours(const std::vector<SurfacePath>& paths, const Leg& a, const Leg& b)
{
  const SurfacePath& path = paths[a.first];
  return a.first == b.first &&
    (b.second == a.second + 1 ||
      (a.second == 0 && b.second + 1 == path.triangles.size() &&
        samePlace(path.points.front(), path.points.back())));
}

/// A triangle in its own plane.
class TriangleMap
{
public:
  TriangleMap(const TriangleMesh& mesh, Index triangle)
    : Origin(mesh.point(mesh.triangle(triangle)[0]))
    , Along((mesh.point(mesh.triangle(triangle)[1]) - Origin).normalized())
    , Across(triangleNormal(mesh, triangle).cross(Along))
  {
  }
  Point2 of(const SurfacePoint& point) const
  {
    const Point3 way = point.position - this->Origin;
    return { this->Along.dot(way), this->Across.dot(way) };
  }

private:
  Point3 Origin;
  Point3 Along;
  Point3 Across;
};
}

std::vector<PathCrossing> pathCrossings(
  const TriangleMesh& mesh, const std::vector<SurfacePath>& paths, std::size_t count)
{
  std::map<Index, std::vector<Leg>> legs;
  for (std::size_t p = 0; p < paths.size(); ++p)
  {
    for (std::size_t i = 0; i < paths[p].triangles.size(); ++i)
    {
      legs[paths[p].triangles[i]].emplace_back(p, i);
    }
  }
  std::vector<PathCrossing> found;
  for (const auto& [triangle, members] : legs)
  {
    const TriangleMap map(mesh, triangle);
    const auto startOf = [&](const Leg& leg) -> const SurfacePoint& {
      return paths[leg.first].points[leg.second];
    };
    const auto endOf = [&](const Leg& leg) -> const SurfacePoint& {
      return paths[leg.first].points[leg.second + 1];
    };
    for (std::size_t k = 0; k < members.size() && members[k].first < count; ++k)
    {
      const Point2 a = map.of(startOf(members[k]));
      const Point2 u = map.of(endOf(members[k])) - a;
      for (std::size_t m = k + 1; m < members.size(); ++m)
      {
        const Point2 b = map.of(startOf(members[m]));
        const Point2 v = map.of(endOf(members[m])) - b;
        const double area = cross(u, v);
        const double size = u.norm() * v.norm();
        if (!(std::abs(area) > touch * size) || areNeighbours(paths, members[k], members[m]))
        {
          continue;
        }
        const double s = cross(b - a, v) / area;
        const double t = cross(b - a, u) / area;
        if (s < -touch || s > 1.0 + touch || t < -touch || t > 1.0 + touch)
        {
          continue;
        }
        const double along = std::clamp(s, 0.0, 1.0);
        found.push_back({ { members[k].first, members[k].second, along },
          { members[m].first, members[m].second, std::clamp(t, 0.0, 1.0) },
          pointBetween(mesh, triangle, startOf(members[k]), endOf(members[k]), along),
          area / size });
      }
    }
  }
  return found;
}
}
