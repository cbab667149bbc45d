// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/SurfaceDevelopability.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
using Place = std::array<double, 3>;

struct BoundaryEdge
{
  std::array<Place, 2> ends; ///< in ascending order
  double length = 0.0;
};

Place placeOf(const TriangleMesh& mesh, Index vertex)
{
  const Point3& p = mesh.point(vertex);
  // -0 and 0 are one place.
  return { p.x() + 0.0, p.y() + 0.0, p.z() + 0.0 };
}
}

double cutLength(const TriangleMesh& mesh)
{
  std::vector<BoundaryEdge> edges;
  for (const Indices& loop : mesh.boundaryLoops())
  {
    for (Index h : loop)
    {
      BoundaryEdge edge{ { placeOf(mesh, mesh.from(h)), placeOf(mesh, mesh.to(h)) },
        mesh.length(h) };
      std::sort(edge.ends.begin(), edge.ends.end());
      edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const BoundaryEdge& a, const BoundaryEdge& b) { return a.ends < b.ends; });
  double length = 0.0;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end)
  {
    while (end < edges.size() && edges[end].ends == edges[begin].ends)
    {
      ++end;
    }
    length += end - begin > 1 ? edges[begin].length : 0.0;
  }
  return length;
}

std::vector<double> cornerAngles(const TriangleMesh& mesh, const Execution& execution)
{
  std::vector<double> angles(mesh.halfedgeCount());
  execution.forEach(mesh.halfedgeCount(), [&](Index h) { angles[h] = mesh.angle(h); });
  return angles;
}

std::vector<double> surfaceDevelopability(
  const TriangleMesh& mesh, const std::vector<double>& angles)
{
  std::vector<double> sum(mesh.vertexCount(), 0.0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    sum[mesh.from(h)] += angles[h];
  }
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const bool inside = mesh.outgoing(v) != none && !mesh.onBoundary(v);
    sum[v] = inside ? std::abs(sum[v] - 2.0 * pi) : 0.0;
  }
  return sum;
}
}
