// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/RigidEmbedding.h"

#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <random>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// One patch, the boundary of a cushion, and positions that stretch and shear it.
struct Problem
{
  WiredSurface wired;
  InteriorSystem system;
  InteriorPatch patch;
  Eigen::MatrixXd positions;

  explicit Problem(double noise, double height = 0.5)
    : wired(cushion(7, 6, height))
  {
    Points2 flat;
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-noise, noise);
    for (const Point3& p : this->wired.piece.mesh.points())
    {
      flat.emplace_back(1.1 * p.x() + 0.2 * p.y() + place(random), 0.8 * p.y() + place(random));
    }
    this->patch = collectInteriorPatches(this->wired.piece, this->wired.network).front();
    this->system.update(this->patch, this->mesh());
    this->positions.resize(static_cast<Eigen::Index>(this->patch.vertices.size()), 2);
    for (std::size_t i = 0; i < this->patch.vertices.size(); ++i)
    {
      this->positions.row(static_cast<Eigen::Index>(i)) = flat[this->patch.vertices[i]].transpose();
    }
  }

  const TriangleMesh& mesh() const { return this->wired.piece.mesh; }
  /// Ready to iterate.
  RigidEmbedding prepared()
  {
    return { this->system, this->system.factor(InteriorWeights::Cotangent, {}), this->positions };
  }
};
}

TEST(RigidEmbedding, DescendsToAStationaryPointInFewSteps)
{
  for (double noise : { 0.0, 0.05, 0.3 })
  {
    Problem problem(noise);
    RigidEmbedding embedding = problem.prepared();
    double energy = embedding.energy(problem.positions);
    const double first = embedding.gradient(problem.positions).norm();
    int steps = 0;
    RigidEmbedding::State state = RigidEmbedding::State::Running;
    while (state == RigidEmbedding::State::Running && steps < 100)
    {
      state = embedding.iterate(1e-12);
      ++steps;
      EXPECT_LE(embedding.energy(embedding.positions()), energy);
      energy = embedding.energy(embedding.positions());
    }
    EXPECT_EQ(state, RigidEmbedding::State::Converged);
    EXPECT_LE(steps, 30);
    EXPECT_LT(embedding.gradient(embedding.positions()).norm(), 1e-6 * first) << noise;
    EXPECT_EQ(embedding.positions().bottomRows(5), problem.positions.bottomRows(5));
  }
}

TEST(RigidEmbedding, EndsWhereTheLocalGlobalMethodEnds)
{
  // The classic iteration, with dense matrices and to its bitter end.
  Problem problem(0.0);
  const Index free = problem.patch.freeCount;
  RigidEmbedding embedding = problem.prepared();
  for (int k = 0; k < 50 && embedding.iterate(0.0) == RigidEmbedding::State::Running; ++k)
  {
  }
  Eigen::MatrixXd positions = problem.positions;
  const Eigen::LLT<Eigen::MatrixXd> global([&] {
    // Curvature where every triangle is stretched without bound, so that turning costs nothing
    // less: the matrix of the global step.
    Eigen::MatrixXd stiffness(2 * free, 2 * free);
    for (Index column = 0; column < 2 * free; ++column)
    {
      Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(free, 2);
      unit(column % free, column / free) = 1.0;
      const Eigen::MatrixXd response = embedding.curvature(1e12 * problem.positions, unit);
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
