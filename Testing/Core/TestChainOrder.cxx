// SPDX-License-Identifier: BSD-3-Clause
#include "ChainOrder.h"
#include "WiredSurface.h"

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

/// Entries of the factor of the wires' graph Laplacian with its vertices in an order.
template <typename Ordering>
Eigen::Index entriesOfFactor(const WireNetwork& network, const Indices& rank)
{
  const auto count = static_cast<Eigen::Index>(rank.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const WireEdge& edge : network.edges)
  {
    const Index a = rank[network.hostOfVertex[edge.from]];
    const Index b = rank[network.hostOfVertex[edge.to]];
    entries.emplace_back(a, a, 1.5);
    entries.emplace_back(b, b, 1.5);
    entries.emplace_back(std::max(a, b), std::min(a, b), -1.0);
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Ordering> factor(matrix);
  return Eigen::SparseMatrix<double>(factor.matrixL()).nonZeros();
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

TEST(ChainOrder, FillsInLittleMoreThanMinimumDegree)
{
  const WiredSurface wired = wiredPatch(40, 32);
  const ChainOrder order(wired.network);
  EXPECT_LE(entriesOfFactor<Eigen::NaturalOrdering<int>>(wired.network, order.rankOfHost),
    1.2 * entriesOfFactor<Eigen::AMDOrdering<int>>(wired.network, order.rankOfHost));
}
