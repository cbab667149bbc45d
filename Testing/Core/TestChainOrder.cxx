// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/DirectionsKkt.h"
#include "Sparse/LeadingElimination.h"
#include "Sparse/LinearSolver.h"
#include "WiredSurface.h"
#include "Wires/ChainOrder.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <numeric>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A patch with a grid of wires.
WiredSurface wiredPatch(Index columns, Index rows)
{
  Surface surface = cushion(columns, rows, 0.3);
  for (Index j = 4; j < rows; j += 4)
  {
    surface.curves.push_back(rowCurve(columns, j));
  }
  for (Index i = 4; i < columns; i += 4)
  {
    surface.curves.push_back(columnCurve(columns, rows, i));
  }
  return WiredSurface(surface);
}

/// Entries of the factor of a symmetric matrix, and of the same with minimum degree throughout.
struct Fill
{
  Eigen::Index ours;
  Eigen::Index minimumDegree;
};

Fill fillOf(const SparseMatrix& lower, Index leading)
{
  const Indices order = leadingColumnsFirst(lower, leading);
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> column(lower.cols());
  std::copy(order.begin(), order.end(), column.indices().data());
  SparseMatrix ordered(lower.rows(), lower.cols());
  ordered.selfadjointView<Eigen::Lower>() =
    lower.selfadjointView<Eigen::Lower>().twistedBy(column.transpose());
  const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> ours(
    ordered);
  const Eigen::SimplicialLDLT<SparseMatrix> theirs(lower);
  return { SparseMatrix(ours.matrixL()).nonZeros(), SparseMatrix(theirs.matrixL()).nonZeros() };
}

/// The graph Laplacian of the wires.
SparseMatrix laplacian(const WireNetwork& network, const ChainOrder& order)
{
  const auto count = static_cast<Eigen::Index>(order.rankOfHost.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const WireEdge& edge : network.edges)
  {
    const Index a = order.rankOfHost[network.hostOfVertex[edge.from]];
    const Index b = order.rankOfHost[network.hostOfVertex[edge.to]];
    entries.emplace_back(a, a, 1.5);
    entries.emplace_back(b, b, 1.5);
    entries.emplace_back(std::max(a, b), std::min(a, b), -1.0);
  }
  SparseMatrix matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}
}

TEST(ChainOrder, PutsJunctionsBehindWhatLiesAlongWires)
{
  const WiredSurface wired = wiredPatch(12, 8);
  const WireNetwork& net = wired.network;
  const ChainOrder order(net);
  Indices sorted = order.rankOfHost;
  std::sort(sorted.begin(), sorted.end());
  Indices all(net.hostVertices.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
  // 2 x 1 crossings inside, 2 x 2 + 1 x 2 ends on the boundary.
  const Index junctions = 8;
  for (const WireEdge& edge : net.edges)
  {
    const bool late =
      std::max(order.rankOfHost[net.hostOfVertex[edge.from]],
        order.rankOfHost[net.hostOfVertex[edge.to]]) >= static_cast<Index>(all.size()) - junctions;
    const Index e = static_cast<Index>(&edge - net.edges.data());
    EXPECT_EQ(order.atJunction[e] != 0, late) << e;
  }
}

TEST(ChainOrder, FillsInLittleMoreThanMinimumDegreeHoweverManyPatchesThereAre)
{
  for (Index side : { 12, 40, 80 })
  {
    const WiredSurface wired = wiredPatch(side, side);
    SCOPED_TRACE(std::to_string(wired.network.loopCount()) + " patches");
    const ChainOrder order(wired.network);
    const Fill ofPlaces = fillOf(laplacian(wired.network, order), order.hostsAlong);
    EXPECT_LE(ofPlaces.ours, 1.2 * ofPlaces.minimumDegree);

    const AngleProblem problem = wired.problem();
    const DirectionsForm form(problem);
    const Eigen::VectorXd x = form.unknowns(form.projectedAngles());
    DirectionsKkt kkt(form);
    kkt.linearize(x, Eigen::VectorXd::Zero(form.constraintCount()), Curvature::Exact, 1e-8);
    kkt.shift(1.0);
    const Fill ofAngles = fillOf(kkt.kkt(), form.rotationsAlongWires());
    EXPECT_LE(ofAngles.ours, 1.2 * ofAngles.minimumDegree);
  }
}
