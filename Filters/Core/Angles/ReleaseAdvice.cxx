// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/ReleaseAdvice.h"

#include "Angles/KeyRelease.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// Most releases that are tried of either kind: each costs a solution of the wires.
constexpr std::size_t mostTried = 3;

/// The least objective when a curve is no wire any more, or a key curve an accessory curve.
double objectiveWithout(Index curve, const WireNetwork& network, const Piece& piece,
  const CutSurface& cut, const std::vector<FeatureCurve>& curves, const AngleSolverOptions& options,
  const Execution& execution)
{
  std::vector<FeatureCurve> others = curves;
  others[curve].type = CurveType::Accessory;
  WireNetwork fewer;
  const WireNetwork* wires = &network;
  Piece bare;
  const Piece* subject = &piece;
  if (curves[curve].type != CurveType::Key)
  {
    bare = piece;
    std::replace(bare.curveOfHalfedge.begin(), bare.curveOfHalfedge.end(), curve, none);
    subject = &bare;
    fewer = buildWireNetwork(bare);
    wires = &fewer;
  }
  if (!wires->status.ok())
  {
    return -1.0;
  }
  const AngleProblem problem =
    makeAngleProblem(*wires, lockKeyCurves(*wires, *subject, cut, others));
  const AngleSolution solution = solveAngles(problem, options, execution);
  return solution.status.ok() ? solution.objective : -1.0;
}

/// Per key curve what its shape alone costs: half the squared changes of its angles.
std::vector<double> shapeCosts(const WireNetwork& network, const std::vector<FeatureCurve>& curves,
  const std::vector<double>& theta)
{
  std::vector<double> cost(curves.size(), 0.0);
  for (Index i = 0; i < network.nodeCount(); ++i)
  {
    const Index curve = network.edges[network.edge[i]].curve;
    if (curve != none && curves[curve].type == CurveType::Key)
    {
      const double change = theta[i] - network.alpha[i];
      cost[curve] += 0.5 * change * change;
    }
  }
  return cost;
}

void sortByMagnitude(const std::vector<double>& value, Indices& ids)
{
  std::stable_sort(ids.begin(), ids.end(),
    [&](Index a, Index b) { return std::abs(value[a]) > std::abs(value[b]); });
}
}

bool liesPoorly(const TriangleMesh& mesh, const Points2& positions)
{
  double least = std::numeric_limits<double>::max();
  double most = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangle(t);
    const Point2 p = positions[c[1]] - positions[c[0]];
    const Point2 q = positions[c[2]] - positions[c[0]];
    const Point3 u = mesh.point(c[1]) - mesh.point(c[0]);
    const Point3 v = mesh.point(c[2]) - mesh.point(c[0]);
    const double ratio = (p.x() * q.y() - p.y() * q.x()) / u.cross(v).norm();
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  return !(least >= poorHomogeneity * most);
}

ReleaseAdvice adviseRelease(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const AngleSolution& solution,
  const AngleSolverOptions& options, bool poor, const Execution& execution)
{
  ReleaseAdvice advice;
  advice.sensitivity.assign(curves.size(), 0.0);
  if (solution.multiplierX.size() != static_cast<std::size_t>(network.loopCount()))
  {
    return advice;
  }
  const std::vector<double> byEdge = lengthSensitivity(network, solution);
  std::vector<char> inside(curves.size(), 0);
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    if (edge.curve != none && edge.otherSide != none)
    {
      inside[edge.curve] = 1;
      advice.sensitivity[edge.curve] += byEdge[e] * solution.length[e];
    }
  }
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (inside[c])
    {
      advice.ranking.push_back(static_cast<Index>(c));
    }
  }
  sortByMagnitude(advice.sensitivity, advice.ranking);
  std::vector<double> without(curves.size(), -1.0);
  if (poor)
  {
    Indices tried;
    for (std::size_t k = 0; k < advice.ranking.size() && tried.size() < mostTried; ++k)
    {
      if (curves[advice.ranking[k]].type != CurveType::Key)
      {
        tried.push_back(advice.ranking[k]);
      }
    }
    Indices keys = keyCurves(network, curves);
    sortByMagnitude(shapeCosts(network, curves, solution.theta), keys);
    keys.resize(std::min(keys.size(), mostTried));
    for (Index key : keys)
    {
      tried.push_back(key);
      if (!inside[key])
      {
        advice.ranking.push_back(key);
      }
    }
    for (Index c : tried)
    {
      without[c] = objectiveWithout(c, network, piece, cut, curves, options, execution);
    }
    std::stable_sort(advice.ranking.begin(), advice.ranking.end(), [&](Index a, Index b) {
      const bool known = without[a] >= 0.0;
      return known != (without[b] >= 0.0) ? known : known && without[a] < without[b];
    });
  }
  for (Index c : advice.ranking)
  {
    advice.objectiveWithout.push_back(without[c]);
  }
  return advice;
}
}
