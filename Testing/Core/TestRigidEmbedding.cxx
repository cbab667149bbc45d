// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/RigidEmbedding.h"

#include "WiredSurface.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

TEST(RigidEmbedding, EndsWhereTheLocalGlobalMethodEnds)
{
  // The classic iteration, with dense matrices and to its bitter end, from positions that stretch
  // and shear a cushion.
  const WiredSurface wired(cushion(7, 6, 0.5));
  InteriorSystem system;
  system.update(collectInteriorPatches(wired.piece, wired.network).front(), wired.piece.mesh);
  const Indices& vertices = system.patch().vertices;
  const Index free = system.patch().freeCount;
  Eigen::MatrixXd start(static_cast<Eigen::Index>(vertices.size()), 2);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Point3& p = wired.piece.mesh.point(vertices[i]);
    start.row(static_cast<Eigen::Index>(i)) << 1.1 * p.x() + 0.2 * p.y(), 0.8 * p.y();
  }
  RigidEmbedding embedding(system, system.factor(InteriorWeights::Cotangent, {}), start);
  for (int k = 0; k < 50 && embedding.iterate(0.0) == RigidEmbedding::State::Running; ++k)
  {
  }
  Eigen::MatrixXd positions = start;
  const Eigen::LLT<Eigen::MatrixXd> global([&] {
    // Curvature where every triangle is stretched without bound, so that turning costs nothing
    // less: the matrix of the global step.
    Eigen::MatrixXd stiffness(2 * free, 2 * free);
    for (Index column = 0; column < 2 * free; ++column)
    {
      Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(free, 2);
      unit(column % free, column / free) = 1.0;
      const Eigen::MatrixXd response = embedding.curvature(1e12 * start, unit);
      stiffness.col(column) << response.col(0), response.col(1);
    }
    return stiffness;
  }());
  for (int k = 0; k < 2000; ++k)
  {
    const Eigen::MatrixXd gradient = embedding.gradient(positions);
    Eigen::VectorXd stacked(2 * free);
    stacked << gradient.col(0), gradient.col(1);
    const Eigen::VectorXd step = global.solve(stacked);
    positions.topRows(free).col(0) -= step.head(free);
    positions.topRows(free).col(1) -= step.tail(free);
  }
  EXPECT_LT((positions - embedding.positions()).cwiseAbs().maxCoeff(), 1e-9);
}
