// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/CutLength.h"

#include <algorithm>

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
}
