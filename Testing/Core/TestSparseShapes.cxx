// SPDX-License-Identifier: BSD-3-Clause
// Every sparse routine against a dense one, on graphs of every shape.
#include "Reference/SuperLUFactorization.h"
#include "Sparse/LinearSolver.h"
#include "Sparse/MultifrontalFactorization.h"
#include "TestGraphs.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace flattening;
using namespace testgraphs;

namespace
{
/// A matrix with the graph's pattern, and its lower triangle.
struct System
{
  Eigen::MatrixXd dense;
  SparseMatrix lower;
};

/// \param negative every so many-th diagonal block is negative: the matrix is then quasi-definite, for
/// which every order of elimination works. 0: positive definite
System makeSystem(const Graph& graph, Index negative, std::mt19937& generator)
{
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  System system{ Eigen::MatrixXd::Zero(graph.count, graph.count), { graph.count, graph.count } };
  const auto sign = [&](Index v) { return negative > 0 && v % negative == 0 ? -1.0 : 1.0; };
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](Index a, Index b) {
    if (a == b)
    {
      return;
    }
    const double v = value(generator);
    entries.emplace_back(std::max(a, b), std::min(a, b), v);
    if (sign(a) == sign(b)) // diagonally dominant within both definite blocks
    {
      entries.emplace_back(a, a, sign(a) * std::abs(v));
      entries.emplace_back(b, b, sign(b) * std::abs(v));
    }
  };
  for (const Triangle& t : graph.cliques)
  {
    couple(t[0], t[1]);
    couple(t[1], t[2]);
    couple(t[2], t[0]);
  }
  for (Index v = 0; v < graph.count; ++v)
  {
    entries.emplace_back(v, v, sign(v) * (0.1 + std::abs(value(generator))));
  }
  system.lower.setFromTriplets(entries.begin(), entries.end());
  system.dense = Eigen::MatrixXd(system.lower).selfadjointView<Eigen::Lower>();
  return system;
}

Points3 randomPlaces(Index count, std::mt19937& generator)
{
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  Points3 places(count);
  for (Point3& p : places)
  {
    p = Point3(value(generator), value(generator), value(generator));
  }
  return places;
}

/// What dense routines say of a system.
struct Truth
{
  Eigen::MatrixXd rightHandSide;
  Eigen::MatrixXd solution;
  Eigen::VectorXd eigenvalues;

  explicit Truth(const System& system)
    : rightHandSide(Eigen::MatrixXd::Ones(system.dense.rows(), 2))
    , solution(system.dense.partialPivLu().solve(rightHandSide))
    , eigenvalues(
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(system.dense, Eigen::EigenvaluesOnly)
          .eigenvalues())
  {
  }
};

void expectSolves(LinearSolver solver, const System& system, const Truth& truth, const char* name)
{
  ASSERT_TRUE(solver.factorize(system.lower)) << name;
  EXPECT_LT(
    (solver.solve(truth.rightHandSide) - truth.solution).norm(), 1e-9 * truth.solution.norm())
    << name;
  EXPECT_EQ(solver.positive(), (truth.eigenvalues.array() > 0.0).count()) << name;
  EXPECT_EQ(solver.negative(), (truth.eigenvalues.array() < 0.0).count()) << name;
  EXPECT_EQ(solver.zero(), 0) << name;
}
}

TEST(SparseShapes, SymmetricFactorsSolveAndTellTheSignsOfTheEigenvalues)
{
  std::mt19937 generator(4);
  for (const Graph& graph : graphs())
  {
    SCOPED_TRACE(graph.name);
    for (Index negative : { 0, 3 })
    {
      const System system = makeSystem(graph, negative, generator);
      const Truth truth(system);
      expectSolves(LinearSolver(dissect(graph.cliques, graph.count)), system, truth, "levels");
      expectSolves(LinearSolver(dissect(graph.cliques, randomPlaces(graph.count, generator))),
        system, truth, "planes");
      for (Index leading : { Index{ 0 }, graph.count / 3, graph.count })
      {
        expectSolves(LinearSolver(LeadingColumns{ leading }), system, truth, "leading columns");
      }
    }
  }
}

TEST(SparseShapes, SuperLUSolvesAsDenseEliminationDoes)
{
  std::mt19937 generator(5);
  for (const Graph& graph : graphs())
  {
    SCOPED_TRACE(graph.name);
    const System definite = makeSystem(graph, 0, generator);
    // Of no symmetry, and with a diagonal that only pivoting avoids.
    Eigen::MatrixXd general = definite.dense;
    general.triangularView<Eigen::StrictlyUpper>() *= -0.7;
    if (graph.count > 1 && general(1, 0) != 0.0)
    {
      general(0, 0) = 0.0;
    }
    const Eigen::MatrixXd rhs = Eigen::MatrixXd::Ones(graph.count, 2);
    const Eigen::FullPivLU<Eigen::MatrixXd> dense(general);
    ASSERT_TRUE(dense.isInvertible());
    SuperLUFactorization solver;
    ASSERT_TRUE(solver.factorize(general.sparseView()));
    const Eigen::MatrixXd expected = dense.solve(rhs);
    EXPECT_LT((solver.solve(rhs) - expected).norm(), 1e-8 * expected.norm());
  }
}

TEST(SparseShapes, SuperLURefusesWhatItCannotFactor)
{
  using Matrix = Eigen::SparseMatrix<double>;
  Matrix singular(16, 16);
  Matrix notFinite(16, 16);
  for (Index k = 0; k < 16; ++k)
  {
    singular.insert(k, k) = k == 5 ? 0.0 : 1.0;
    notFinite.insert(k, k) = k == 3 ? std::numeric_limits<double>::quiet_NaN() : 1.0;
  }
  singular.makeCompressed();
  notFinite.makeCompressed();
  for (const Matrix& matrix : { singular, notFinite, Matrix(4, 5), Matrix(16, 16) })
  {
    EXPECT_FALSE(SuperLUFactorization().factorize(matrix));
  }
}
