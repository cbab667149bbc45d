// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/AngleProblem.h"

#include "Base/Types.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// How far a connector may go from its length on the surface, and what free lengths cost: little,
/// so that the angles decide.
constexpr double connectorTolerance = 0.9;
constexpr double stretchWeight = 1e-2;

/// The sides of the boundary's edges from one end of another wire to the next.
std::vector<Indices> boundaryStretches(const AngleProblem& problem)
{
  const WireNetwork& network = *problem.network;
  const auto isBoundary = [&](Index side) {
    const WireEdge& edge = network.edges[network.edge[side]];
    return edge.curve == none && !edge.connector && problem.held[network.edge[side]];
  };
  const auto continues = [&](Index side) {
    const Index host = network.hostOfVertex[network.vertex[side]];
    return isBoundary(network.previous[side]) &&
      network.vertexNodeBegin[host + 1] - network.vertexNodeBegin[host] ==
      (network.interior[host] ? 2 : 1);
  };
  std::vector<Indices> stretches;
  std::vector<char> done(network.edges.size(), 0);
  for (const WireEdge& edge : network.edges)
  {
    Index side = edge.side;
    if (!isBoundary(side) || done[network.edge[side]])
    {
      continue;
    }
    while (continues(side) && network.previous[side] != edge.side)
    {
      side = network.previous[side];
    }
    stretches.emplace_back();
    do
    {
      done[network.edge[side]] = 1;
      stretches.back().push_back(side);
      side = network.next[side];
    } while (isBoundary(side) && !done[network.edge[side]] && continues(side));
  }
  return stretches;
}

/// Elastic curves, and stretches of an elastic boundary, stretch as one, each edge of a connector
/// on its own.
void addStretchGroups(
  const std::vector<FeatureCurve>& curves, const CurveRules& rules, AngleProblem& problem)
{
  const WireNetwork& network = *problem.network;
  for (const Indices& sides :
    rules.boundaryTolerance > 0.0 ? boundaryStretches(problem) : std::vector<Indices>())
  {
    for (const Index side : sides)
    {
      problem.stretchGroup[network.edge[side]] = static_cast<Index>(problem.groups.size());
    }
    problem.groups.push_back(
      { rules.boundaryTolerance, stretchWeight * static_cast<double>(sides.size()) });
  }
  Indices groupOfCurve(curves.size(), none);
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    const Index curve = problem.held[e] ? edge.curve : none;
    if (edge.connector)
    {
      problem.stretchGroup[e] = static_cast<Index>(problem.groups.size());
      problem.groups.push_back({ connectorTolerance, stretchWeight });
    }
    else if (curve != none && rules.decidedStretch(curve))
    {
      problem.length[e] *= 1.0 + *rules.decidedStretch(curve);
    }
    else if (curve != none && curves[curve].tolerance > 0.0)
    {
      Index& group = groupOfCurve[curve];
      if (group == none)
      {
        group = static_cast<Index>(problem.groups.size());
        problem.groups.push_back({ curves[curve].tolerance, 0.0 });
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
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    problem.held[e] = holdsLength(network.edges[e], curves, rules.freeBoundary);
  }
  for (Index i = 0; rules.freeBoundary && i < network.nodeCount(); ++i)
  {
    const bool free =
      !problem.held[network.edge[i]] || !problem.held[network.edge[network.previous[i]]];
    problem.weight[i] = free ? 0.0 : problem.weight[i];
  }
  addStretchGroups(curves, rules, problem);
  return problem;
}

AngleProblem makeAngleProblem(const WireNetwork& network, NodeLocks locks)
{
  AngleProblem problem;
  problem.network = &network;
  problem.target = network.alpha;
  problem.locks = std::move(locks);
  problem.weight.resize(network.nodeCount());
  for (Index i = 0; i < network.nodeCount(); ++i)
  {
    problem.weight[i] = network.isHole(network.loop[i]) ? 0.0 : 1.0;
  }
  problem.length.reserve(network.edges.size());
  for (const WireEdge& edge : network.edges)
  {
    problem.length.push_back(edge.length);
  }
  problem.held.assign(network.edges.size(), 1);
  problem.stretchGroup.assign(network.edges.size(), none);
  return problem;
}

double angleObjective(const AngleProblem& problem, const std::vector<double>& theta)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < theta.size(); ++i)
  {
    if (!problem.locks.locked[i])
    {
      const double d = theta[i] - problem.target[i];
      sum += 0.5 * problem.weight[i] * d * d;
    }
  }
  return sum;
}

std::vector<double> sideDirections(const WireNetwork& network, const std::vector<double>& theta)
{
  std::vector<double> phi(theta.size());
  for (Index loop = 0; loop < network.loopCount(); ++loop)
  {
    double direction = 0.0;
    for (Index i = network.loopBegin[loop]; i < network.loopBegin[loop + 1]; ++i)
    {
      direction += pi - theta[i]; // Eq. 3
      phi[i] = direction;
    }
  }
  return phi;
}

std::vector<double> edgeDirections(const WireNetwork& network, const std::vector<double>& theta)
{
  std::vector<double> psi(network.edges.size(), 0.0);
  std::vector<char> loopDone(network.loopCount(), 0);
  Indices queue{ 0 };
  auto backwards = [&network](Index side) { return network.alongEdge(side) ? 0.0 : pi; };
  for (std::size_t at = 0; at < queue.size(); ++at)
  {
    const Index start = queue[at];
    if (loopDone[network.loop[start]])
    {
      continue;
    }
    loopDone[network.loop[start]] = 1;
    double direction = psi[network.edge[start]] + backwards(start);
    Index side = start;
    do
    {
      if (side != start)
      {
        direction += pi - theta[side];
        psi[network.edge[side]] = direction - backwards(side);
      }
      if (network.twin[side] != none && !loopDone[network.loop[network.twin[side]]])
      {
        queue.push_back(network.twin[side]);
      }
      side = network.next[side];
    } while (side != start);
  }
  return psi;
}

double interiorAngle(const Point2& before, const Point2& at, const Point2& after)
{
  const Point2 in = at - before;
  const Point2 out = after - at;
  return pi - std::atan2(cross(in, out), in.dot(out));
}

std::vector<double> planarAngles(const AngleProblem& problem, const Points2& positions)
{
  const WireNetwork& net = *problem.network;
  std::vector<double> theta(net.nodeCount(), 2.0 * pi);
  for (Index i = 0; i < net.nodeCount(); ++i)
  {
    if (net.edge[i] != net.edge[net.previous[i]])
    {
      const Point2& at = positions[net.vertex[i]];
      const double angle =
        interiorAngle(positions[net.vertex[net.previous[i]]], at, positions[net.endVertex(i)]);
      theta[i] = nearestBranch(angle, problem.target[i]);
    }
  }
  return theta;
}

std::vector<double> stretchBounds(const AngleProblem& problem)
{
  std::vector<double> bounds;
  for (const StretchGroup& group : problem.groups)
  {
    bounds.push_back(group.tolerance);
  }
  return bounds;
}

std::vector<double> stretchedLengths(
  const AngleProblem& problem, const std::vector<double>& stretch)
{
  std::vector<double> lengths = problem.length;
  for (std::size_t e = 0; e < lengths.size(); ++e)
  {
    const Index group = problem.stretchGroup[e];
    lengths[e] *= group == none ? 1.0 : 1.0 + stretch[group];
  }
  return lengths;
}

AngleConstraints::AngleConstraints(const AngleProblem& problem)
  : Problem(&problem)
  , ColumnOfNode(problem.network->nodeCount(), none)
  , VertexRow(problem.network->hostVertices.size(), none)
  , Rows(3 * problem.network->loopCount())
{
  const WireNetwork& net = *problem.network;
  for (Index i = 0; i < net.nodeCount(); ++i)
  {
    if (!problem.locks.locked[i])
    {
      this->ColumnOfNode[i] = this->freeCount();
      this->FreeNodes.push_back(i);
    }
  }
  for (std::size_t host = 0; host < net.hostVertices.size(); ++host)
  {
    const auto begin = net.vertexNodes.begin() + net.vertexNodeBegin[host];
    const auto end = net.vertexNodes.begin() + net.vertexNodeBegin[host + 1];
    if (net.interior[host] &&
      std::any_of(begin, end, [&problem](Index i) { return !problem.locks.locked[i]; }))
    {
      this->VertexRow[host] = this->Rows++;
    }
  }
}

Eigen::VectorXd AngleConstraints::residual(const std::vector<double>& theta) const
{
  const WireNetwork& net = *this->Problem->network;
  const std::vector<double> phi = sideDirections(net, theta);
  Eigen::VectorXd r = Eigen::VectorXd::Zero(this->Rows);
  for (Index loop = 0; loop < net.loopCount(); ++loop)
  {
    const Index begin = net.loopBegin[loop];
    const Index end = net.loopBegin[loop + 1];
    r[3 * loop] = (end - begin - 2) * pi;
    for (Index i = begin; i < end; ++i)
    {
      const double l = this->Problem->length[net.edge[i]];
      r[3 * loop] -= theta[i];
      r[3 * loop + 1] += l * std::cos(phi[i]);
      r[3 * loop + 2] += l * std::sin(phi[i]);
    }
  }
  for (std::size_t host = 0; host < net.hostVertices.size(); ++host)
  {
    if (this->VertexRow[host] != none)
    {
      double& sum = r[this->VertexRow[host]];
      sum = 2.0 * pi;
      for (Index k = net.vertexNodeBegin[host]; k < net.vertexNodeBegin[host + 1]; ++k)
      {
        sum -= theta[net.vertexNodes[k]];
      }
    }
  }
  return r;
}

Eigen::SparseMatrix<double> AngleConstraints::jacobian(const std::vector<double>& theta) const
{
  const WireNetwork& net = *this->Problem->network;
  const std::vector<double> phi = sideDirections(net, theta);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * this->FreeNodes.size());
  for (Index loop = 0; loop < net.loopCount(); ++loop)
  {
    Point2 sum = Point2::Zero();
    for (Index i = net.loopBegin[loop + 1] - 1; i >= net.loopBegin[loop]; --i)
    {
      const double l = this->Problem->length[net.edge[i]];
      sum += Point2(l * std::sin(phi[i]), -l * std::cos(phi[i])); // Eqs. 18 and 19
      const Index column = this->ColumnOfNode[i];
      if (column != none)
      {
        entries.emplace_back(3 * loop, column, -1.0);
        entries.emplace_back(3 * loop + 1, column, sum.x());
        entries.emplace_back(3 * loop + 2, column, sum.y());
      }
    }
  }
  for (std::size_t host = 0; host < net.hostVertices.size(); ++host)
  {
    for (Index k = net.vertexNodeBegin[host]; k < net.vertexNodeBegin[host + 1]; ++k)
    {
      const Index column = this->ColumnOfNode[net.vertexNodes[k]];
      if (this->VertexRow[host] != none && column != none)
      {
        entries.emplace_back(this->VertexRow[host], column, -1.0); // Eq. 16
      }
    }
  }
  Eigen::SparseMatrix<double> jacobian(this->Rows, this->freeCount());
  jacobian.setFromTriplets(entries.begin(), entries.end());
  return jacobian;
}

double closureResidual(
  const WireNetwork& network, const std::vector<double>& theta, const std::vector<double>& length)
{
  const std::vector<double> phi = sideDirections(network, theta);
  double worst = 0.0;
  for (Index loop = 0; loop < network.loopCount(); ++loop)
  {
    Point2 end = Point2::Zero();
    for (Index i = network.loopBegin[loop]; i < network.loopBegin[loop + 1]; ++i)
    {
      end += length[network.edge[i]] * Point2(std::cos(phi[i]), std::sin(phi[i])); // Eq. 8
    }
    worst = std::max(worst, end.norm());
  }
  return worst;
}

double perimeter(const AngleProblem& problem)
{
  double sum = 0.0;
  for (std::size_t e = 0; e < problem.network->edges.size(); ++e)
  {
    sum += problem.network->edges[e].otherSide == none ? problem.length[e] : 0.0;
  }
  return sum;
}
}
