// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/WireLayout.h"

#include "Angles/AngleProblem.h"
#include "Base/CompressedRows.h"
#include "Sparse/LinearSolver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{
/// Each step doubles the digits: after these nothing but what contradicts itself is left.
constexpr int maxLengthSteps = 8;

/// The host vertices of an edge.
std::array<Index, 2> ends(const WireNetwork& network, std::size_t e)
{
  const WireEdge& edge = network.edges[e];
  return { network.hostOfVertex[edge.from], network.hostOfVertex[edge.to] };
}

/// Vector from start to end of each edge.
Points2 edgeVectors(
  const WireNetwork& network, const std::vector<double>& theta, const std::vector<double>& length)
{
  const std::vector<double> psi = edgeDirections(network, theta);
  Points2 vectors(network.edges.size());
  for (std::size_t e = 0; e < vectors.size(); ++e)
  {
    vectors[e] = length[e] * Point2(std::cos(psi[e]), std::sin(psi[e]));
  }
  return vectors;
}

/// Host vertices placed edge by edge, breadth first (Eq. 8).
Points2 placeAlongTree(const WireNetwork& network, const Points2& vectors)
{
  const std::size_t count = network.hostVertices.size();
  const CompressedRows incident = groupMembers(count, [&network](const auto& visit) {
    for (Index e = 0; e < network.edgeCount(); ++e)
    {
      const auto [from, to] = ends(network, e);
      visit(from, e);
      visit(to, e);
    }
  });
  Points2 positions(count, Point2::Zero());
  std::vector<char> placed(count, 0);
  Indices queue{ 0 };
  placed[0] = 1;
  for (std::size_t at = 0; at < queue.size(); ++at)
  {
    const Index host = queue[at];
    for (Index e : incident[host])
    {
      const auto [from, to] = ends(network, e);
      const Index other = from == host ? to : from;
      if (!placed[other])
      {
        placed[other] = 1;
        positions[other] = from == host ? Point2(positions[host] + vectors[e])
                                        : Point2(positions[host] - vectors[e]);
        queue.push_back(other);
      }
    }
  }
  return positions;
}

double largestMiss(const WireNetwork& network, const Points2& positions, const Points2& vectors)
{
  double worst = 0.0;
  for (std::size_t e = 0; e < vectors.size(); ++e)
  {
    const auto [from, to] = ends(network, e);
    worst = std::max(worst, (positions[to] - positions[from] - vectors[e]).norm());
  }
  return worst;
}

/// Vertices and edges follow each other along a wire by their numbers, so that each in turn leaves
/// one neighbor only where it is eliminated. What is at a junction of wires comes last.
struct EliminationOrder
{
  explicit EliminationOrder(const WireNetwork& network)
    : degree(hostDegrees(network))
  {
    const auto isAlong = [this](std::size_t host) { return this->degree[host] == 2; };
    this->hosts = rankFirst(this->degree.size(), isAlong);
    this->edges = rankFirst(network.edges.size(), [&](std::size_t e) {
      const auto [from, to] = ends(network, e);
      return isAlong(from) && isAlong(to);
    });
  }

  Indices degree; ///< per entry of hostVertices, how many edges are there
  RankedFirst hosts;
  RankedFirst edges;
};

/// Positions whose edges come nearest to the vectors in the least squares sense; the first stays.
void spreadMisses(const WireNetwork& network, const Points2& vectors, const EliminationOrder& order,
  Points2& positions)
{
  const auto count = static_cast<Eigen::Index>(positions.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(count, 2);
  for (std::size_t e = 0; e < vectors.size(); ++e)
  {
    const auto [from, to] = ends(network, e);
    const Index a = order.hosts.rank[from];
    const Index b = order.hosts.rank[to];
    entries.emplace_back(a, a, 1.0);
    entries.emplace_back(b, b, 1.0);
    entries.emplace_back(std::max(a, b), std::min(a, b), -1.0);
    rhs.row(b) += vectors[e].transpose();
    rhs.row(a) -= vectors[e].transpose();
  }
  entries.emplace_back(order.hosts.rank[0], order.hosts.rank[0], 1.0);
  SparseMatrix laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  LinearSolver solver(LeadingColumns{ order.hosts.first });
  if (!solver.factorize(laplacian))
  {
    return;
  }
  const Eigen::MatrixXd x = solver.solveRefined(laplacian, rhs);
  for (Eigen::Index k = 0; k < count && x.rows() == count; ++k)
  {
    positions[k] = x.row(order.hosts.rank[k]).transpose();
  }
}

double largestLengthError(
  const WireNetwork& network, const Points2& positions, const std::vector<double>& length)
{
  double worst = 0.0;
  for (std::size_t e = 0; e < network.edges.size(); ++e)
  {
    const auto [from, to] = ends(network, e);
    const double placed = (positions[to] - positions[from]).norm();
    worst = std::max(worst, std::abs(placed - length[e]) / length[e]);
  }
  return worst;
}

/// Newton's method on all lengths with the least change d of the positions, [I, J'; J, 0]
/// [d; y] = [0; r]. A small block in the corner serves networks that carry a self-stress. To
/// eliminate the changes first leaves J J', in which all edges at a hub of wires would be coupled:
/// the changes of hubs come later.
class LengthCorrection
{
public:
  LengthCorrection(
    const WireNetwork& network, const std::vector<double>& length, const EliminationOrder& order)
    : Network(network)
    , Length(length)
    , FirstColumn(network.hostVertices.size())
    , Row(network.edges.size())
  {
    const Index enough = hubValence(network.edgeCount());
    const auto hubs = static_cast<Index>(std::count_if(order.degree.begin(), order.degree.end(),
      [enough](Index degree) { return degree > enough; }));
    const auto hosts = static_cast<Index>(order.degree.size());
    // Changes but those of hubs, edges along wires, changes of hubs, edges at junctions.
    Index next = 0;
    Index nextHub = 2 * (hosts - hubs) + order.edges.first;
    this->Solver = LinearSolver(LeadingColumns{ nextHub });
    for (std::size_t host = 0; host < this->FirstColumn.size(); ++host)
    {
      Index& place = order.degree[host] > enough ? nextHub : next;
      this->FirstColumn[host] = place;
      place += 2;
    }
    for (std::size_t e = 0; e < this->Row.size(); ++e)
    {
      const Index rank = order.edges.rank[e];
      this->Row[e] = rank + 2 * (rank < order.edges.first ? hosts - hubs : hosts);
    }
  }

  /// Takes the derivatives at positions, which then serve for steps from all places nearby.
  bool linearize(const Points2& positions)
  {
    const auto coordinates = static_cast<Index>(2 * positions.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(5 * this->Length.size() + static_cast<std::size_t>(coordinates));
    for (Index column : this->FirstColumn)
    {
      entries.emplace_back(column, column, 1.0);
      entries.emplace_back(column + 1, column + 1, 1.0);
    }
    for (std::size_t e = 0; e < this->Length.size(); ++e)
    {
      const auto [a, b] = ends(this->Network, e);
      const Point2 d = positions[b] - positions[a];
      const double l = d.norm();
      if (!(l > 0.0))
      {
        return false;
      }
      const Index row = this->Row[e];
      for (int k = 0; k < 2; ++k)
      {
        for (const auto& [host, part] : { std::pair(a, -d[k] / l), std::pair(b, d[k] / l) })
        {
          const Index column = this->FirstColumn[host] + k;
          entries.emplace_back(std::max(row, column), std::min(row, column), part);
        }
      }
      entries.emplace_back(row, row, 0.0);
    }
    const Index size = coordinates + this->Network.edgeCount();
    this->Kkt.resize(size, size);
    this->Kkt.setFromTriplets(entries.begin(), entries.end());
    SparseMatrix regular = this->Kkt;
    for (Index row : this->Row)
    {
      regular.coeffRef(row, row) = -regularization;
    }
    return this->Solver.factorize(regular);
  }

  bool step(Points2& positions) const
  {
    Eigen::VectorXd rightHandSide = Eigen::VectorXd::Zero(this->Kkt.rows());
    for (std::size_t e = 0; e < this->Length.size(); ++e)
    {
      const auto [a, b] = ends(this->Network, e);
      rightHandSide[this->Row[e]] = this->Length[e] - (positions[b] - positions[a]).norm();
    }
    const Eigen::MatrixXd change = this->Solver.solveRefined(this->Kkt, rightHandSide);
    if (change.rows() != rightHandSide.size())
    {
      return false;
    }
    for (std::size_t k = 0; k < positions.size(); ++k)
    {
      positions[k] += change.block<2, 1>(this->FirstColumn[k], 0);
    }
    return true;
  }

private:
  const WireNetwork& Network;
  const std::vector<double>& Length;
  Indices FirstColumn; ///< per host, of its two
  Indices Row;         ///< per edge
  SparseMatrix Kkt;
  LinearSolver Solver;
};

/// \param positions per host vertex.
void makeLengthsExact(const WireNetwork& network, const std::vector<double>& length,
  const EliminationOrder& order, Points2& positions)
{
  // Below it one step with the derivatives of a place nearby leaves nothing but rounding.
  constexpr double near = 1e-7;
  LengthCorrection correction(network, length, order);
  double error = largestLengthError(network, positions, length);
  bool linearized = false;
  for (int step = 0; step < maxLengthSteps && error > 1e-14; ++step)
  {
    if (!linearized || error > near)
    {
      if (!correction.linearize(positions))
      {
        break;
      }
      linearized = true;
    }
    Points2 corrected = positions;
    if (!correction.step(corrected))
    {
      break;
    }
    const double after = largestLengthError(network, corrected, length);
    if (!(after < error))
    {
      break;
    }
    error = after;
    positions = std::move(corrected);
  }
}
}

Points2 layOutWires(
  const WireNetwork& network, const std::vector<double>& theta, const std::vector<double>& length)
{
  const Points2 vectors = edgeVectors(network, theta, length);
  const EliminationOrder order(network);
  Points2 hosts = placeAlongTree(network, vectors);
  const double size = std::accumulate(length.begin(), length.end(), 0.0);
  if (largestMiss(network, hosts, vectors) > 1e-14 * size)
  {
    spreadMisses(network, vectors, order, hosts);
  }
  makeLengthsExact(network, length, order, hosts);
  Points2 positions(network.hostOfVertex.size(), Point2::Zero());
  for (std::size_t k = 0; k < hosts.size(); ++k)
  {
    positions[network.hostVertices[k]] = hosts[k];
  }
  return positions;
}

void correctWireLengths(
  const WireNetwork& network, const std::vector<double>& length, Points2& positions)
{
  Points2 hosts(network.hostVertices.size());
  for (std::size_t k = 0; k < hosts.size(); ++k)
  {
    hosts[k] = positions[network.hostVertices[k]];
  }
  makeLengthsExact(network, length, EliminationOrder(network), hosts);
  for (std::size_t k = 0; k < hosts.size(); ++k)
  {
    positions[network.hostVertices[k]] = hosts[k];
  }
}
}
