// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SeamTree.h"

#include "Quality/ScaleFactor.h"
#include "Suggestion/ChartClusters.h"
#include "Surface/EdgePaths.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{
/// Tips that are compared, and how far apart they are, in sqrt(area / pi).
constexpr std::size_t maxTips = 16;
constexpr double tipsApart = 0.2;
/// What is added to the length of a path, in sqrt(area / pi): short ones gain much for their length
/// and are many.
constexpr double fixedLength = 0.5;

/// The vertex end along edges from some.
Index farthestFrom(const TriangleMesh& mesh, Index start)
{
  const EdgePaths paths(mesh, { start }, {}, EdgePaths::Through::Boundary);
  Index end = start;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (paths.reaches(v) && paths.distance(v) > paths.distance(end))
    {
      end = v;
    }
  }
  return end;
}

/// Vertices where the factor is largest, apart from each other and from where it is zero.
Indices tipsOf(const TriangleMesh& mesh, const std::vector<double>& factor, double apart)
{
  Indices order(mesh.vertexCount());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](Index a, Index b) { return std::abs(factor[a]) > std::abs(factor[b]); });
  Indices tips;
  for (Index v : order)
  {
    const bool near = std::any_of(tips.begin(), tips.end(),
      [&](Index tip) { return (mesh.point(tip) - mesh.point(v)).norm() < apart; });
    if (factor[v] != 0.0 && !near && tips.size() < maxTips)
    {
      tips.push_back(v);
    }
  }
  return tips;
}
}

SeamTree::SeamTree(const TriangleMesh& mesh)
  : Mesh(mesh)
  , Size(std::sqrt(mesh.area() / pi))
  , Cut(mesh.halfedgeCount(), 0)
{
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (mesh.onBoundary(v))
    {
      this->Vertices.push_back(v);
    }
  }
  if (this->Vertices.empty())
  {
    // Between two ends of the longest way, which are tips.
    const Index first = farthestFrom(mesh, farthestFrom(mesh, mesh.triangle(0)[0]));
    this->Vertices = { first };
    this->add(EdgePaths(mesh, { first }).path(farthestFrom(mesh, first)));
  }
}

bool SeamTree::grow(double bound, const Execution& execution)
{
  Indices triangles(this->Mesh.triangleCount());
  std::iota(triangles.begin(), triangles.end(), 0);
  while (!execution.cancelled() &&
    forecastStrain(openedPart(this->Mesh, triangles, this->Cut).mesh) > bound)
  {
    ScaleFactorOptions options;
    options.fixed = this->Vertices;
    const ScaleFactor factor(this->Mesh, options, execution);
    const EdgePaths paths(this->Mesh, this->Vertices, {}, EdgePaths::Through::Boundary);
    Indices best;
    double most = 0.0;
    for (Index tip : tipsOf(this->Mesh, factor.values(), tipsApart * this->Size))
    {
      if (!paths.reaches(tip))
      {
        continue;
      }
      Indices path = paths.path(tip);
      const double gain =
        factor.forecast(path).gain / (paths.distance(tip) + fixedLength * this->Size);
      if (gain > most)
      {
        most = gain;
        best = std::move(path);
      }
    }
    if (best.empty())
    {
      return false;
    }
    this->add(best);
  }
  return !execution.cancelled();
}

void SeamTree::add(const Indices& path)
{
  for (std::size_t k = 1; k < path.size(); ++k)
  {
    const Index h = this->Mesh.find(path[k - 1], path[k]);
    const Index side = h == none ? this->Mesh.find(path[k], path[k - 1]) : h;
    const Index twin = this->Mesh.twin(side);
    if (twin != none)
    {
      this->Cut[side] = this->Cut[twin] = 1;
    }
  }
  this->Vertices.insert(this->Vertices.end(), path.begin(), path.end());
  sortUnique(this->Vertices);
}
}
