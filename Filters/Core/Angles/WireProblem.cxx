// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/WireProblem.h"

namespace flattening
{
namespace
{
/// How far a connector may go from its length on the surface, and what free lengths cost: little,
/// so that the angles decide.
constexpr double connectorTolerance = 0.9;
constexpr double stretchWeight = 1e-2;

/// Elastic curves stretch as one, each edge of a connector on its own.
void addStretchGroups(
  const std::vector<FeatureCurve>& curves, const CurveRules& rules, AngleProblem& problem)
{
  const WireNetwork& network = *problem.network;
  Indices groupOfCurve(curves.size(), none);
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    if (edge.connector)
    {
      problem.stretchGroup[e] = static_cast<Index>(problem.groups.size());
      problem.groups.push_back({ connectorTolerance, stretchWeight });
    }
    else if (edge.curve != none && rules.decidedStretch(edge.curve))
    {
      problem.length[e] *= 1.0 + *rules.decidedStretch(edge.curve);
    }
    else if (edge.curve != none && curves[edge.curve].tolerance > 0.0)
    {
      Index& group = groupOfCurve[edge.curve];
      if (group == none)
      {
        group = static_cast<Index>(problem.groups.size());
        problem.groups.push_back({ curves[edge.curve].tolerance, 0.0 });
      }
      problem.stretchGroup[e] = group;
      problem.groups[group].weight += stretchWeight;
    }
  }
}
}

AngleProblem makeWireProblem(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const CurveRules& rules)
{
  AngleProblem problem =
    makeAngleProblem(network, lockKeyCurves(network, piece, cut, curves, rules));
  addStretchGroups(curves, rules, problem);
  return problem;
}
}
