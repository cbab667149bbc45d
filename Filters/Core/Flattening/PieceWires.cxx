// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceWires.h"

#include "Angles/KeyRelease.h"
#include "Angles/ProgressiveWarping.h"
#include "Embedding/ConformalMap.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// How far a connector may go from its length on the surface, and what elastic lengths cost:
/// little, so that the angles decide.
constexpr double connectorTolerance = 0.9;
constexpr double stretchWeight = 1e-2;

/// Elastic curves stretch as one, each edge of a connector on its own.
void addStretchGroups(
  const WireNetwork& network, const std::vector<FeatureCurve>& curves, AngleProblem& problem)
{
  Indices groupOfCurve(curves.size(), none);
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    if (edge.connector)
    {
      problem.stretchGroup[e] = static_cast<Index>(problem.groups.size());
      problem.groups.push_back({ connectorTolerance, stretchWeight });
    }
    else if (edge.curve != none && curves[edge.curve].stretch)
    {
      problem.length[e] *= 1.0 + *curves[edge.curve].stretch;
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

/// Angles and lengths of the wires in a conformal map, to start from where the plain start fails.
AngleStart conformalStart(
  const Piece& piece, const WireNetwork& network, const Execution& execution)
{
  AngleStart start;
  start.theta = network.alpha;
  for (const WireEdge& edge : network.edges)
  {
    start.length.push_back(edge.length);
  }
  const ConformalMap map = mapConformally(piece.mesh, {}, execution);
  if (!map.status.ok())
  {
    return start;
  }
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    start.length[e] = (map.positions[edge.to] - map.positions[edge.from]).norm();
  }
  for (Index i = 0; i < network.nodeCount(); ++i)
  {
    const Point2& at = map.positions[network.vertex[i]];
    const Point2 in = at - map.positions[network.vertex[network.previous[i]]];
    const Point2 out = map.positions[network.endVertex(i)] - at;
    const bool tip = network.edge[i] == network.edge[network.previous[i]];
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    start.theta[i] = tip ? 2.0 * pi : pi - turn;
  }
  return start;
}
}

PieceWires::PieceWires(const Piece& piece, const WireNetwork& network, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const FlatteningOptions& options,
  const Execution& execution)
  : Subject(piece)
  , Network(network)
  , Cut(cut)
  , Curves(curves)
  , Options(options)
  , Execute(execution)
{
}

WireSolution PieceWires::solve() const
{
  NodeLocks locks = lockKeyCurves(this->Network, this->Subject, this->Cut, this->Curves);
  Indices released;
  if (this->Options.releaseKeys)
  {
    std::fill(locks.locked.begin(), locks.locked.end(), 0);
    locks.lockedCount = 0;
    released = keyCurves(this->Network, this->Curves);
  }
  WireSolution wires = this->solveFor(locks);
  wires.released = std::move(released);
  const bool canRelease =
    locks.lockedCount > 0 && !wires.status.ok() && wires.status.code != StatusCode::Cancelled;
  return canRelease ? this->release(std::move(wires), {}) : wires;
}

WireSolution PieceWires::release(WireSolution failed, const Acceptance& accepts) const
{
  failed.angles.status = failed.status;
  auto solution = [&](const NodeLocks& locks) {
    WireSolution wires = this->solveFor(locks);
    if (wires.status.ok() && accepts && !accepts(wires))
    {
      wires.angles.status = { StatusCode::IncompatibleKeys, "the piece folds over", {} };
    }
    return wires.angles;
  };
  KeyRelease release =
    releaseKeys(this->Network, this->Subject, this->Cut, this->Curves, failed.angles, solution);
  failed.status = release.status;
  if (release.released.empty())
  {
    return failed;
  }
  WireSolution wires = this->solveFor(release.locks);
  wires.status = std::move(release.status);
  wires.released = std::move(release.released);
  return wires;
}

ReleaseAdvice PieceWires::advise(const WireSolution& wires, bool poor) const
{
  const bool turned =
    !wires.status.ok() || largestAngleChange(wires.problem, wires.angles.theta) > poorAngleChange;
  std::vector<FeatureCurve> curves = this->Curves;
  for (Index c : wires.released)
  {
    curves[c].type = CurveType::Accessory;
  }
  return adviseRelease(this->Network, this->Subject, this->Cut, curves, wires.angles,
    this->Options.angles, poor || turned, this->Execute);
}

WireSolution PieceWires::solveFor(const NodeLocks& locks) const
{
  WireSolution wires;
  wires.problem = makeAngleProblem(this->Network, locks);
  addStretchGroups(this->Network, this->Curves, wires.problem);
  wires.problem.alternativeStart = [this] {
    return conformalStart(this->Subject, this->Network, this->Execute);
  };
  if (this->Options.scheme == Scheme::Progressive)
  {
    this->warpPatches(wires);
  }
  else
  {
    wires.angles = solveAngles(wires.problem, this->Options.angles, this->Execute);
  }
  if (wires.angles.status.ok() && locks.lockedCount > 0 &&
    std::isinf(largestAngleChange(wires.problem, wires.angles.theta)))
  {
    wires.angles.status = { StatusCode::IncompatibleKeys,
      "the shapes of the key curves together fold a wire's angle over", {} };
  }
  wires.status = wires.angles.status;
  return wires;
}

void PieceWires::warpPatches(WireSolution& wires) const
{
  AngleProblem problem = wires.problem;
  AngleSolution elastic;
  if (!problem.groups.empty())
  {
    // Lengths that may change are chosen for the piece as a whole, then warped patch by patch.
    elastic = solveAngles(problem, this->Options.angles, this->Execute);
    if (!elastic.status.ok())
    {
      wires.angles = std::move(elastic);
      return;
    }
    problem.length = elastic.length;
    problem.groups.clear();
    problem.stretchGroup.assign(problem.stretchGroup.size(), none);
  }
  ProgressiveSolution progressive = warpProgressively(problem, this->Options.angles, this->Execute);
  for (Index loop : progressive.warpingOrder)
  {
    wires.warpingOrder.push_back(this->Network.patchOfLoop[loop]);
  }
  wires.angles = std::move(progressive.angles);
  wires.angles.stretch = elastic.stretch;
}
}
