// SPDX-License-Identifier: BSD-3-Clause
#include "Wires/KeyCurveLocks.h"

#include "Base/Types.h"
#include "Sparse/LinearSolver.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// The wire-nodes at a vertex from the wire edge of a side that starts there, counter-clockwise, to
/// the wire edge towards another vertex; empty where the surface ends in between.
Indices nodesBetween(const WireNetwork& network, Index startSide, Index endVertex)
{
  Indices nodes;
  Index side = startSide;
  do
  {
    nodes.push_back(side);
    const Index incoming = network.previous[side];
    if (network.vertex[incoming] == endVertex)
    {
      return nodes;
    }
    side = network.twin[incoming];
  } while (side != none && side != startSide);
  return {};
}

/// The side of a dart that comes from one vertex of its curve and goes on to another, vertices of
/// the surface before the cut; without nodes where there is none.
DartSideVertex sideVertexAt(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  Index host, Index to, Index from)
{
  const auto original = [&](Index v) { return cut.originalVertex[piece.vertices[v]]; };
  DartSideVertex found;
  found.host = host;
  Index start = none;
  for (Index n = network.vertexNodeBegin[host]; n < network.vertexNodeBegin[host + 1]; ++n)
  {
    const Index side = network.vertexNodes[n];
    const Index incoming = network.previous[side];
    if (network.isHole(network.loop[side]))
    {
      continue;
    }
    if (original(network.endVertex(side)) == to)
    {
      start = side;
      found.after = network.endVertex(side);
    }
    if (original(network.vertex[incoming]) == from)
    {
      found.before = network.vertex[incoming];
    }
  }
  if (start != none && found.before != none)
  {
    found.nodes = nodesBetween(network, start, found.before);
  }
  return found;
}
}

std::vector<DartSideVertex> findDartSides(const WireNetwork& network, const Piece& piece,
  const CutSurface& cut, const std::vector<FeatureCurve>& curves)
{
  std::vector<DartSideVertex> all;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const Indices& vertices = curves[c].vertices;
    if (curves[c].type != CurveType::Dart || curves[c].closed())
    {
      continue;
    }
    Indices placeOf(cut.originalVertexCount, none);
    for (std::size_t k = 1; k + 1 < vertices.size(); ++k)
    {
      placeOf[vertices[k]] = static_cast<Index>(k);
    }
    for (Index host = 0; host < static_cast<Index>(network.hostVertices.size()); ++host)
    {
      const Index k = placeOf[cut.originalVertex[piece.vertices[network.hostVertices[host]]]];
      if (k == none)
      {
        continue;
      }
      const Index last = vertices[k - 1];
      const Index next = vertices[k + 1];
      DartSideVertex left = sideVertexAt(network, piece, cut, host, next, last);
      DartSideVertex right = sideVertexAt(network, piece, cut, host, last, next);
      if (left.nodes.empty() == right.nodes.empty())
      {
        continue; // branches off, or joined
      }
      left.onLeft = !left.nodes.empty();
      DartSideVertex& one = left.onLeft ? left : right;
      one.curve = static_cast<Index>(c);
      one.place = k;
      all.push_back(std::move(one));
    }
  }
  return all;
}

namespace
{
/// Nodes that a shaped key curve leaves on one side of it at a vertex, and the angle they must sum
/// to.
struct SideSum
{
  Indices nodes;
  double angle;
  Index curve = none;
};

/// Least change of the angles, relative to their size, that meets all sums; with one sum a side
/// this divides each side in proportion.
void meetSums(const Indices& nodes, const std::vector<SideSum>& sums, std::vector<double>& angle)
{
  // The angle of a hole can be zero or less on the surface.
  auto weight = [](double surfaceAngle) { return std::max(surfaceAngle, 1e-3); };
  const auto n = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(sums.size()), n);
  Eigen::VectorXd b(static_cast<Eigen::Index>(sums.size()));
  for (std::size_t r = 0; r < sums.size(); ++r)
  {
    const auto row = static_cast<Eigen::Index>(r);
    b[row] = sums[r].angle;
    for (Eigen::Index c = 0; c < n; ++c)
    {
      const Index node = nodes[c];
      for (Index member : sums[r].nodes)
      {
        if (member == node)
        {
          A(row, c) = std::sqrt(weight(angle[node]));
          b[row] -= angle[node];
        }
      }
    }
  }
  const Eigen::VectorXd x = leastNormSolution(A, b);
  for (Eigen::Index c = 0; c < n; ++c)
  {
    angle[nodes[c]] += std::sqrt(weight(angle[nodes[c]])) * x[c];
  }
}

double turningAngle(const Point2& a, const Point2& b, const Point2& c)
{
  // Scaled, so that no product over- or underflows.
  const Point2 u = (b - a) / (b - a).cwiseAbs().maxCoeff();
  const Point2 v = (c - b) / (c - b).cwiseAbs().maxCoeff();
  return std::atan2(cross(u, v), u.dot(v));
}

/// Where a host vertex is joined to a neighbour, a vertex of the surface before the cut.
struct Passage
{
  Index side = none;   ///< that starts at the host towards it
  Index vertex = none; ///< its copy in the piece
};

template <class Original>
Passage passageTo(
  const WireNetwork& network, const Original& original, std::size_t host, Index neighbour)
{
  Passage passage;
  for (Index n = network.vertexNodeBegin[host]; n < network.vertexNodeBegin[host + 1]; ++n)
  {
    const Index side = network.vertexNodes[n];
    const Index outer = network.endVertex(side);
    const Index inner = network.vertex[network.previous[side]];
    passage.side = original(outer) == neighbour ? side : passage.side;
    passage.vertex = original(outer) == neighbour ? outer : passage.vertex;
    passage.vertex = original(inner) == neighbour ? inner : passage.vertex;
  }
  return passage;
}

/// Sums that the planar shapes of the key curves through each host vertex prescribe.
std::vector<std::vector<SideSum>> collectSideSums(const WireNetwork& network, const Piece& piece,
  const CutSurface& cut, const std::vector<FeatureCurve>& curves, const CurveRules& rules)
{
  auto original = [&](Index v) { return cut.originalVertex[piece.vertices[v]]; };
  std::vector<std::vector<SideSum>> sums(network.hostVertices.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const FeatureCurve& curve = curves[c];
    const auto key = static_cast<Index>(c);
    if (curve.type != CurveType::Key || curve.keyShape == KeyShape::Surface || rules.releases(key))
    {
      continue;
    }
    // Position in the chain of each original vertex, to find where the curve passes through.
    Indices placeOf(cut.originalVertexCount, none);
    for (std::size_t k = 0; k < curve.vertices.size(); ++k)
    {
      placeOf[curve.vertices[k]] = static_cast<Index>(k);
    }
    const auto count = static_cast<Index>(curve.vertices.size());
    for (std::size_t host = 0; host < network.hostVertices.size(); ++host)
    {
      const Index k = placeOf[original(network.hostVertices[host])];
      if (k == none || (!curve.closed() && (k == 0 || k == count - 1)))
      {
        continue;
      }
      const Index before = k == 0 || k == count - 1 ? count - 2 : k - 1;
      const Index after = k == count - 1 ? 1 : k + 1;
      double turn = 0.0;
      if (curve.keyShape == KeyShape::Planar)
      {
        turn =
          turningAngle(curve.planarShape[before], curve.planarShape[k], curve.planarShape[after]);
      }
      const Passage ahead = passageTo(network, original, host, curve.vertices[after]);
      const Passage behind = passageTo(network, original, host, curve.vertices[before]);
      if (ahead.side != none && behind.vertex != none)
      {
        sums[host].push_back({ nodesBetween(network, ahead.side, behind.vertex), pi - turn, key });
      }
      if (behind.side != none && ahead.vertex != none)
      {
        sums[host].push_back({ nodesBetween(network, behind.side, ahead.vertex), pi + turn, key });
      }
    }
  }
  return sums;
}

/// Both sides of a dart turn towards its cloth by the same angles, so that it folds.
void addLegSums(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const CurveRules& rules,
  std::vector<std::vector<SideSum>>& sums)
{
  if (rules.legTurns.empty())
  {
    return;
  }
  for (DartSideVertex& one : findDartSides(network, piece, cut, curves))
  {
    const std::vector<double>& turns = rules.legTurns[one.curve];
    if (!turns.empty())
    {
      sums[one.host].push_back({ std::move(one.nodes), pi - turns[one.place], one.curve });
    }
  }
}
}

NodeLocks freeNodes(const WireNetwork& network)
{
  NodeLocks locks;
  locks.locked.assign(network.nodeCount(), 0);
  locks.angle = network.alpha;
  return locks;
}

NodeLocks lockKeyCurves(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const CurveRules& rules)
{
  NodeLocks locks = freeNodes(network);
  auto sideSums = collectSideSums(network, piece, cut, curves, rules);
  addLegSums(network, piece, cut, curves, rules, sideSums);

  // A curve that keeps its angles on the surface holds every node at each of its vertices.
  std::vector<char> held(network.hostVertices.size(), 0);
  for (const WireEdge& edge : network.edges)
  {
    if (edge.curve != none && curves[edge.curve].type == CurveType::Key &&
      curves[edge.curve].keyShape == KeyShape::Surface && !rules.releases(edge.curve))
    {
      held[network.hostOfVertex[edge.from]] = held[network.hostOfVertex[edge.to]] = 1;
    }
  }
  for (std::size_t host = 0; host < network.hostVertices.size(); ++host)
  {
    std::vector<SideSum> sums;
    for (const SideSum& sum : sideSums[host])
    {
      if (!sum.nodes.empty())
      {
        sums.push_back(sum);
      }
    }
    if (!held[host] && sums.empty())
    {
      continue;
    }
    Indices nodes;
    for (Index k = network.vertexNodeBegin[host]; k < network.vertexNodeBegin[host + 1]; ++k)
    {
      nodes.push_back(network.vertexNodes[k]);
    }
    if (network.interior[host])
    {
      double sum = 0.0;
      for (Index node : nodes)
      {
        sum += network.alpha[node];
      }
      for (Index node : nodes)
      {
        locks.angle[node] = 2.0 * pi * network.alpha[node] / sum; // Eq. 1
      }
    }
    if (!sums.empty())
    {
      if (network.interior[host])
      {
        sums.push_back({ nodes, 2.0 * pi });
      }
      meetSums(nodes, sums, locks.angle);
    }
    for (Index node : nodes)
    {
      locks.locked[node] = 1;
      ++locks.lockedCount;
    }
  }
  return locks;
}

Indices keyCurves(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves)
{
  Indices keys;
  for (const WireEdge& edge : network.edges)
  {
    if (edge.curve != none && curves[edge.curve].type == CurveType::Key)
    {
      keys.push_back(edge.curve);
    }
  }
  // A curve along edges that belong to others has a shape to keep nevertheless.
  for (const std::vector<SideSum>& sums : collectSideSums(network, piece, cut, curves, {}))
  {
    for (const SideSum& sum : sums)
    {
      if (!sum.nodes.empty())
      {
        keys.push_back(sum.curve);
      }
    }
  }
  sortUnique(keys);
  return keys;
}
}
