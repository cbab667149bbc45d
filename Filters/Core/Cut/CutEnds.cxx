// SPDX-License-Identifier: BSD-3-Clause
#include "Cut/CutEnds.h"

#include "Surface/VertexFan.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// How many cuts run through each vertex.
Indices countCuts(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves)
{
  Indices cuts(mesh.vertexCount(), 0);
  for (const FeatureCurve& curve : curves)
  {
    if (curve.opens())
    {
      Indices own = curve.vertices;
      std::sort(own.begin(), own.end());
      own.erase(std::unique(own.begin(), own.end()), own.end());
      for (const Index v : own)
      {
        ++cuts[v];
      }
    }
  }
  return cuts;
}

/// Turns the least from the edge before -> end.
Index boundaryNeighbour(const TriangleMesh& mesh, Index before, Index end)
{
  const Point3 along = (mesh.point(end) - mesh.point(before)).normalized();
  Index best = none;
  double bestCosine = -2.0;
  for (const Index h : VertexFan(mesh, end)) // inside, so that all neighbours are met
  {
    const Index to = mesh.to(h);
    const double cosine = along.dot((mesh.point(to) - mesh.point(end)).normalized());
    if (mesh.onBoundary(to) && cosine > bestCosine)
    {
      best = to;
      bestCosine = cosine;
    }
  }
  return best;
}
}

std::vector<ShortEnd> endsShortOfBoundary(
  const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves)
{
  std::vector<ShortEnd> ends;
  const Indices cuts = countCuts(mesh, curves);
  const auto reaches = [&](Index v) { return mesh.onBoundary(v) || cuts[v] > 1; };
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const Indices& chain = curves[c].vertices;
    if (!curves[c].opens() || curves[c].closed() || chain.size() < 2)
    {
      continue;
    }
    const bool dart = curves[c].type == CurveType::Dart;
    if (dart && (reaches(chain.front()) || reaches(chain.back())))
    {
      continue;
    }
    std::vector<ShortEnd> found;
    for (const auto& [before, end] :
      { std::pair{ chain[1], chain.front() }, std::pair{ chain[chain.size() - 2], chain.back() } })
    {
      const Index boundary = reaches(end) ? none : boundaryNeighbour(mesh, before, end);
      if (boundary != none)
      {
        found.push_back({ static_cast<Index>(c), end, boundary });
      }
    }
    const auto distance = [&mesh](const ShortEnd& e) {
      return (mesh.point(e.boundary) - mesh.point(e.vertex)).squaredNorm();
    };
    if (dart && found.size() == 2)
    {
      found.erase(found.begin() + (distance(found[1]) < distance(found[0]) ? 0 : 1));
    }
    ends.insert(ends.end(), found.begin(), found.end());
  }
  return ends;
}
}
