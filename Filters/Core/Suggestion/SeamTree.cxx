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
constexpr std::size_t maxTreeTips = 16;
constexpr double tipsApart = 0.2;
/// What is added to the length of a path, in sqrt(area / pi): short ones gain much for their length
/// and are many.
constexpr double fixedLength = 0.5;
/// What a path takes, in steps of a flattening.
constexpr double pathSteps = 40.0;

/// The vertex farthest from another along edges.
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

bool SeamTree::grow(double bound, TrialBudget& budget, const Execution& execution)
{
  Indices triangles(this->Mesh.triangleCount());
  std::iota(triangles.begin(), triangles.end(), 0);
  Indices vertices(this->Mesh.vertexCount());
  std::iota(vertices.begin(), vertices.end(), 0);
  while (!execution.cancelled() && !budget.spent() &&
    forecastStrain(openedPart(this->Mesh, triangles, this->Cut).mesh) > bound)
  {
    budget.pay(pathSteps * static_cast<double>(this->Mesh.triangleCount()));
    ScaleFactorOptions options;
    options.fixed = this->Vertices;
    const ScaleFactor factor(this->Mesh, options, execution);
    const EdgePaths paths(this->Mesh, this->Vertices, {}, EdgePaths::Through::Boundary);
    Indices best;
    double most = 0.0;
    for (Index tip : factor.peaks(vertices, tipsApart * this->Size, maxTreeTips))
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
  return !execution.cancelled() && !budget.spent();
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
