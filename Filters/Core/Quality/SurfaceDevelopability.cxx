// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/SurfaceDevelopability.h"

#include <cmath>

namespace flattening
{
std::vector<double> cornerAngles(const TriangleMesh& mesh, const Execution& execution)
{
  std::vector<double> angles(mesh.halfedgeCount());
  execution.parallelFor(mesh.halfedgeCount(), [&](Index begin, Index end) {
    for (Index h = begin; h < end; ++h)
    {
      angles[h] = mesh.angle(h);
    }
  });
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
