// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/WireLayout.h"

#include "Angles/AngleProblem.h"
#include "Base/CompressedRows.h"
#include "Sparse/LinearSolver.h"

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
void spreadMisses(const WireNetwork& network, const Points2& vectors, Points2& positions)
{
  const auto count = static_cast<Eigen::Index>(positions.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(count, 2);
  for (std::size_t e = 0; e < vectors.size(); ++e)
  {
    const Index a = network.hostOfVertex[network.edges[e].from];
    const Index b = network.hostOfVertex[network.edges[e].to];
    entries.emplace_back(a, a, 1.0);
    entries.emplace_back(b, b, 1.0);
    entries.emplace_back(std::max(a, b), std::min(a, b), -1.0);
    rhs.row(b) += vectors[e].transpose();
    rhs.row(a) -= vectors[e].transpose();
  }
  entries.emplace_back(0, 0, 1.0);
  SparseMatrix laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  LinearSolver solver;
  if (!solver.factorize(laplacian))
  {
    return;
  }
  const Eigen::MatrixXd x = solver.solveRefined(laplacian, rhs);
  for (Eigen::Index k = 0; k < count && x.rows() == count; ++k)
  {
    positions[k] = x.row(k).transpose();
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

/// Newton's method on all lengths with the least change d of the positions, [I, J'; J, 0]
/// [d; y] = [0; r]. A small block in the corner serves networks that carry a self-stress. To
/// eliminate the changes first leaves J J', in which all edges at a hub of wires would be coupled:
/// the changes of hubs are ordered among the edges.
class LengthCorrection
{
public:
  LengthCorrection(const WireNetwork& network, const std::vector<double>& length)
    : Network(network)
    , Length(length)
    , FirstColumn(network.hostVertices.size(), 0)
  {
    for (const WireEdge& edge : network.edges)
    {
      ++this->FirstColumn[network.hostOfVertex[edge.from]];
      ++this->FirstColumn[network.hostOfVertex[edge.to]];
    }
    const auto middle = [enough = hubValence(network.edgeCount())](
                          Index degree) { return degree <= enough; };
    const auto hosts = static_cast<Index>(this->FirstColumn.size());
    const auto others =
      static_cast<Index>(std::count_if(this->FirstColumn.begin(), this->FirstColumn.end(), middle));
    this->Solver = LinearSolver(LeadingColumns{ 2 * others });
    Index next = 0;
    Index nextHub = 2 * others;
    for (Index& column : this->FirstColumn)
    {
      Index& place = middle(column) ? next : nextHub;
      column = place;
      place += 2;
    }
    this->FirstRow = 2 * hosts;
  }

  /// Takes the derivatives at positions, which then serve for steps from all places nearby.
  bool linearize(const Points2& positions)
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(5 * this->Length.size() + static_cast<std::size_t>(this->FirstRow));
    for (Index k = 0; k < this->FirstRow; ++k)
    {
      entries.emplace_back(k, k, 1.0);
    }
    for (std::size_t e = 0; e < this->Length.size(); ++e)
    {
      const auto [a, b] = this->ends(e);
      const Point2 d = positions[b] - positions[a];
      const double l = d.norm();
      if (!(l > 0.0))
      {
        return false;
      }
      const Index row = this->FirstRow + static_cast<Index>(e);
      for (int k = 0; k < 2; ++k)
      {
        entries.emplace_back(row, this->FirstColumn[a] + k, -d[k] / l);
        entries.emplace_back(row, this->FirstColumn[b] + k, d[k] / l);
      }
      entries.emplace_back(row, row, 0.0);
    }
    const Index size = this->FirstRow + this->Network.edgeCount();
    this->Kkt.resize(size, size);
    this->Kkt.setFromTriplets(entries.begin(), entries.end());
    SparseMatrix regular = this->Kkt;
    for (Index row = this->FirstRow; row < size; ++row)
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
      const auto [a, b] = this->ends(e);
      rightHandSide[this->FirstRow + static_cast<Index>(e)] =
        this->Length[e] - (positions[b] - positions[a]).norm();
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
  std::array<Index, 2> ends(std::size_t e) const
  {
    return { this->Network.hostOfVertex[this->Network.edges[e].from],
      this->Network.hostOfVertex[this->Network.edges[e].to] };
  }

  const WireNetwork& Network;
  const std::vector<double>& Length;
  Indices FirstColumn; ///< per host, of its two
  Index FirstRow = 0;  ///< of the edges'
  SparseMatrix Kkt;
  LinearSolver Solver;
};

/// \param positions per host vertex. \return the largest relative error that is left.
double makeLengthsExact(
  const WireNetwork& network, const std::vector<double>& length, Points2& positions)
{
  // Below it one step with the derivatives of a place nearby leaves nothing but rounding.
  constexpr double near = 1e-7;
  LengthCorrection correction(network, length);
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
  Points2 positions = placeAlongTree(network, vectors);
  double size = 0.0;
  for (double l : length)
  {
    size += l;
  }
  if (largestMiss(network, positions, vectors) > 1e-14 * size)
  {
    spreadMisses(network, vectors, positions);
  }
  const double error = makeLengthsExact(network, length, positions);
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
  const double error = makeLengthsExact(network, length, hosts);
  for (std::size_t k = 0; k < hosts.size(); ++k)
  {
    positions[network.hostVertices[k]] = hosts[k];
  }
  return error;
}
}
