// SPDX-License-Identifier: BSD-3-Clause
#include "ReleaseAdvice.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// The least objective when a curve is no wire any more.
double objectiveWithout(Index curve, Piece piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const AngleSolverOptions& options,
  const Execution& execution)
{
  std::replace(piece.curveOfHalfedge.begin(), piece.curveOfHalfedge.end(), curve, none);
  const WireNetwork network = buildWireNetwork(piece);
  if (!network.status.ok())
  {
    return -1.0;
  }
  std::vector<FeatureCurve> others = curves;
  others[curve].type = CurveType::Accessory;
  const AngleProblem problem =
    makeAngleProblem(network, lockKeyCurves(network, piece, cut, others));
  const AngleSolution solution = solveAngles(problem, options, execution);
  return solution.status.ok() ? solution.objective : -1.0;
}
}

ReleaseAdvice adviseRelease(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const AngleSolution& solution,
  const AngleSolverOptions& options, bool tryFirst, const Execution& execution)
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
  std::stable_sort(advice.ranking.begin(), advice.ranking.end(), [&](Index a, Index b) {
    return std::abs(advice.sensitivity[a]) > std::abs(advice.sensitivity[b]);
  });
  if (tryFirst && !advice.ranking.empty())
  {
    advice.objectiveWithoutFirst =
      objectiveWithout(advice.ranking.front(), piece, cut, curves, options, execution);
  }
  return advice;
}
}
