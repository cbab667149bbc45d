// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/WireLayout.h"

#include "Angles/AngleProblem.h"
#include "Base/CompressedRows.h"
#include "Sparse/LinearSolver.h"
#include "Wires/ChainOrder.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
constexpr int mostLengthSteps = 8;

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
      visit(network.hostOfVertex[network.edges[e].from], e);
      visit(network.hostOfVertex[network.edges[e].to], e);
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
      const Index from = network.hostOfVertex[network.edges[e].from];
      const Index other = from == host ? network.hostOfVertex[network.edges[e].to] : from;
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
    const WireEdge& edge = network.edges[e];
    const Point2 placed =
      positions[network.hostOfVertex[edge.to]] - positions[network.hostOfVertex[edge.from]];
    worst = std::max(worst, (placed - vectors[e]).norm());
  }
  return worst;
}

/// Positions whose edges come nearest to the vectors in the least squares sense; the first stays.
void spreadMisses(
  const WireNetwork& network, const Points2& vectors, const ChainOrder& order, Points2& positions)
{
  const auto count = static_cast<Eigen::Index>(positions.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(count, 2);
  for (std::size_t e = 0; e < vectors.size(); ++e)
  {
    const Index a = order.rankOfHost[network.hostOfVertex[network.edges[e].from]];
    const Index b = order.rankOfHost[network.hostOfVertex[network.edges[e].to]];
    entries.emplace_back(a, a, 1.0);
    entries.emplace_back(b, b, 1.0);
    entries.emplace_back(std::max(a, b), std::min(a, b), -1.0);
    rhs.row(b) += vectors[e].transpose();
    rhs.row(a) -= vectors[e].transpose();
  }
  entries.emplace_back(order.rankOfHost[0], order.rankOfHost[0], 1.0);
  SparseMatrix laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  LinearSolver solver(LeadingColumns{ order.hostsAlong });
  if (!solver.factorize(laplacian))
  {
    return;
  }
  const Eigen::MatrixXd x = solver.solveRefined(laplacian, rhs);
  for (Eigen::Index k = 0; k < count && x.rows() == count; ++k)
  {
    positions[k] = x.row(order.rankOfHost[k]).transpose();
  }
}

double largestLengthError(
  const WireNetwork& network, const Points2& positions, const std::vector<double>& length)
{
  double worst = 0.0;
  for (std::size_t e = 0; e < network.edges.size(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    const double placed =
      (positions[network.hostOfVertex[edge.to]] - positions[network.hostOfVertex[edge.from]])
        .norm();
    worst = std::max(worst, std::abs(placed - length[e]) / length[e]);
  }
  return worst;
}

/// Newton's method on all lengths with the least change of the positions. A small block on the
/// normal matrix serves networks that carry a self-stress. The edges at a hub of wires would all be
/// coupled there; its changes stay unknowns of their own.
class LengthCorrection
{
public:
  LengthCorrection(
    const WireNetwork& network, const std::vector<double>& length, const ChainOrder& order)
    : Network(network)
    , Length(length)
    , RankOfEdge(order.rankOfEdge)
    , HubColumn(network.hostVertices.size(), none)
    , Solver(LeadingColumns{ order.edgesAlong })
  {
    const Index enough = hubValence(network.edgeCount());
    for (std::size_t host = 0; host < this->HubColumn.size(); ++host)
    {
      if (order.degree[host] > enough)
      {
        this->HubColumn[host] = this->HubColumns;
        this->HubColumns += 2;
      }
    }
  }

  /// Takes the derivatives at positions, which then serve for steps from all places nearby.
  bool linearize(const Points2& positions)
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * this->Length.size());
    for (std::size_t e = 0; e < this->Length.size(); ++e)
    {
      const auto [a, b] = this->ends(e);
      const Point2 d = positions[b] - positions[a];
      const double l = d.norm();
      if (!(l > 0.0))
      {
        return false;
      }
      for (int k = 0; k < 2; ++k)
      {
        entries.emplace_back(this->RankOfEdge[e], 2 * a + k, -d[k] / l);
        entries.emplace_back(this->RankOfEdge[e], 2 * b + k, d[k] / l);
      }
    }
    const auto edges = static_cast<Eigen::Index>(this->Length.size());
    this->Jacobian.resize(edges, 2 * static_cast<Eigen::Index>(positions.size()));
    this->Jacobian.setFromTriplets(entries.begin(), entries.end());
    this->Normal = this->HubColumns == 0 ? SparseMatrix(this->Jacobian * this->Jacobian.transpose())
                                         : this->normalWithHubs();
    SparseMatrix regular = this->Normal;
    for (Eigen::Index e = 0; e < edges; ++e)
    {
      regular.coeffRef(e, e) += regularization;
    }
    return this->Solver.factorize(regular);
  }

  bool step(Points2& positions) const
  {
    Eigen::VectorXd residual(static_cast<Eigen::Index>(this->Length.size()));
    for (std::size_t e = 0; e < this->Length.size(); ++e)
    {
      const auto [a, b] = this->ends(e);
      residual[this->RankOfEdge[e]] = this->Length[e] - (positions[b] - positions[a]).norm();
    }
    Eigen::VectorXd rightHandSide = Eigen::VectorXd::Zero(residual.size() + this->HubColumns);
    rightHandSide.head(residual.size()) = residual;
    const Eigen::MatrixXd y = this->Solver.solveRefined(this->Normal, rightHandSide);
    if (y.rows() != rightHandSide.size())
    {
      return false;
    }
    const Eigen::VectorXd change = this->Jacobian.transpose() * y.col(0).head(residual.size());
    for (std::size_t k = 0; k < positions.size(); ++k)
    {
      positions[k] += change.segment<2>(2 * static_cast<Eigen::Index>(k));
    }
    return true;
  }

private:
  /// [N N', H; H', -I], lower triangle, where N and H are the columns of the other hosts and of the
  /// hubs: the second rows say that a hub's change is H' y, as that of every host is.
  SparseMatrix normalWithHubs() const
  {
    const auto edges = static_cast<Index>(this->Jacobian.rows());
    SparseMatrix others = this->Jacobian;
    std::vector<Eigen::Triplet<double>> entries;
    for (Index column = 0; column < others.cols(); ++column)
    {
      const Index hub = this->HubColumn[column / 2];
      for (SparseMatrix::InnerIterator entry(others, column); hub != none && entry; ++entry)
      {
        entries.emplace_back(
          edges + hub + column % 2, static_cast<Index>(entry.row()), entry.value());
        entry.valueRef() = 0.0;
      }
    }
    others.prune(0.0);
    const SparseMatrix normal = others * others.transpose();
    for (Index column = 0; column < edges; ++column)
    {
      for (SparseMatrix::InnerIterator entry(normal, column); entry; ++entry)
      {
        if (entry.row() >= column)
        {
          entries.emplace_back(static_cast<Index>(entry.row()), column, entry.value());
        }
      }
      entries.emplace_back(column, column, 0.0); // an edge between hubs
    }
    for (Index k = 0; k < this->HubColumns; ++k)
    {
      entries.emplace_back(edges + k, edges + k, -1.0);
    }
    SparseMatrix result(edges + this->HubColumns, edges + this->HubColumns);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  std::array<Index, 2> ends(std::size_t e) const
  {
    return { this->Network.hostOfVertex[this->Network.edges[e].from],
      this->Network.hostOfVertex[this->Network.edges[e].to] };
  }

  const WireNetwork& Network;
  const std::vector<double>& Length;
  const Indices& RankOfEdge;
  Indices HubColumn; ///< per host: of the first of its two unknowns behind the edges, or none
  Index HubColumns = 0;
  SparseMatrix Jacobian;
  SparseMatrix Normal;
  LinearSolver Solver;
};

/// \param positions per host vertex. \return the largest relative error that is left.
double makeLengthsExact(const WireNetwork& network, const std::vector<double>& length,
  const ChainOrder& order, Points2& positions)
{
  // Below it one step with the derivatives of a place nearby leaves nothing but rounding.
  constexpr double near = 1e-7;
  LengthCorrection correction(network, length, order);
  double error = largestLengthError(network, positions, length);
  bool linearized = false;
  for (int step = 0; step < mostLengthSteps && error > 1e-14; ++step)
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
  return error;
}
}

WireLayout layOutWires(
  const WireNetwork& network, const std::vector<double>& theta, const std::vector<double>& length)
{
  WireLayout layout;
  const Points2 vectors = edgeVectors(network, theta, length);
  const ChainOrder order(network);
  Points2 positions = placeAlongTree(network, vectors);
  double size = 0.0;
  for (double l : length)
  {
    size += l;
  }
  if (largestMiss(network, positions, vectors) > 1e-14 * size)
  {
    spreadMisses(network, vectors, order, positions);
  }
  const double error = makeLengthsExact(network, length, order, positions);
  layout.maximumLengthError = error;
  layout.positions.assign(network.hostOfVertex.size(), Point2::Zero());
  for (std::size_t k = 0; k < positions.size(); ++k)
  {
    layout.positions[network.hostVertices[k]] = positions[k];
  }
  return layout;
}

double correctWireLengths(
  const WireNetwork& network, const std::vector<double>& length, Points2& positions)
{
  Points2 hosts(network.hostVertices.size());
  for (std::size_t k = 0; k < hosts.size(); ++k)
  {
    hosts[k] = positions[network.hostVertices[k]];
  }
  const double error = makeLengthsExact(network, length, ChainOrder(network), hosts);
  for (std::size_t k = 0; k < hosts.size(); ++k)
  {
    positions[network.hostVertices[k]] = hosts[k];
  }
  return error;
}
}
