// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/InteriorSystem.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
InteriorPatch patchOf(const WiredSurface& wired)
{
  return collectInteriorPatches(wired.piece, wired.network).front();
}

/// A factorization that is begun under it gives nothing.
Execution cancelled()
{
  Execution execution;
  execution.cancel = [] { return true; };
  return execution;
}
}

TEST(InteriorSystem, FactorsAgainOnlyWhereVerticesHaveMoved)
{
  const WiredSurface wired(cushion(12, 9, 0.4));
  const WiredSurface moved(cushion(12, 9, 0.2));
  for (const InteriorWeights weights :
    { InteriorWeights::InverseLength, InteriorWeights::Cotangent })
  {
    InteriorSystem system;
    system.update(patchOf(wired), wired.piece.mesh);
    EXPECT_EQ(system.factor(weights, cancelled()), nullptr) << "nothing is there yet";
    ASSERT_NE(system.factor(weights, {}), nullptr);
    system.update(patchOf(wired), wired.piece.mesh);
    EXPECT_NE(system.factor(weights, cancelled()), nullptr) << "the same surface";
    system.update(patchOf(moved), moved.piece.mesh);
    EXPECT_EQ(system.factor(weights, cancelled()), nullptr) << "another shape";
    EXPECT_NE(system.factor(weights, {}), nullptr);
  }
}

TEST(InteriorSystem, PutsEachVertexIntoTheWeightedMeanOfItsNeighbours)
{
  const WiredSurface wired(cushion(12, 9, 0.4));
  InteriorSystem system;
  system.update(patchOf(wired), wired.piece.mesh);
  const InteriorPatch& patch = system.patch();
  for (const InteriorWeights weights :
    { InteriorWeights::InverseLength, InteriorWeights::Cotangent })
  {
    Eigen::MatrixXd positions(static_cast<Eigen::Index>(patch.vertices.size()), 2);
    for (std::size_t i = 0; i < patch.vertices.size(); ++i)
    {
      positions.row(static_cast<Eigen::Index>(i)) =
        wired.piece.mesh.point(patch.vertices[i]).head<2>().transpose();
    }
    ASSERT_TRUE(system.solve(weights, {}, positions));
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(positions.rows(), 2);
    const std::vector<EdgeWeights> edges = system.edgeWeights(weights);
    for (std::size_t t = 0; t < edges.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index a = patch.triangles[t][(k + 1) % 3];
        const Index b = patch.triangles[t][(k + 2) % 3];
        pull.row(a) += edges[t][k] * (positions.row(b) - positions.row(a));
        pull.row(b) += edges[t][k] * (positions.row(a) - positions.row(b));
      }
    }
    EXPECT_LT(pull.topRows(patch.freeCount).cwiseAbs().maxCoeff(), 1e-12);
  }
}
