// SPDX-License-Identifier: BSD-3-Clause
#include "Base/CompressedRows.h"
#include "Reference/SuperLUFactorization.h"
#include "Sparse/LinearSolver.h"
#include "Sparse/MultifrontalFactorization.h"
#include "Sparse/NestedDissection.h"
#include "TestGraphs.h"
#include "TestMeshes.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace flattening;
using namespace testgraphs;
using namespace testmeshes;

namespace
{
enum class Method
{
  MinimumDegree,
  Dissected,
};
constexpr std::array<Method, 2> bothMethods{ Method::MinimumDegree, Method::Dissected };

LinearSolver make(Method method, Eigen::Index size)
{
  if (method == Method::MinimumDegree)
  {
    return LinearSolver();
  }
  Dissection order;
  for (Index k = 0; k < static_cast<Index>(size); ++k)
  {
    order.order.push_back(k);
    order.endRange(k + 1);
  }
  return LinearSolver(std::move(order));
}

/// [H C'; C -delta I], quasi-definite: as many negative eigenvalues as rows of C.
SparseMatrix saddlePoint(int side, int constraints, double delta, unsigned seed)
{
  const SparseMatrix hessian = gridLaplacian(side);
  const Eigen::Index n = hessian.rows();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index column = 0; column < n; ++column)
  {
    for (SparseMatrix::InnerIterator it(hessian, column); it; ++it)
    {
      entries.emplace_back(it.row(), it.col(), it.value());
    }
  }
  for (int c = 0; c < constraints; ++c)
  {
    for (int k = 0; k < 5; ++k)
    {
      const auto column = static_cast<int>(random() % static_cast<unsigned>(n));
      const double v = value(random);
      entries.emplace_back(n + c, column, v);
      entries.emplace_back(column, n + c, v);
    }
    entries.emplace_back(n + c, n + c, -delta);
  }
  SparseMatrix matrix(n + constraints, n + constraints);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::MatrixXd someRightHandSide(Eigen::Index rows)
{
  Eigen::MatrixXd rhs(rows, 2);
  for (Eigen::Index i = 0; i < rows; ++i)
  {
    rhs(i, 0) = std::sin(0.7 * static_cast<double>(i));
    rhs(i, 1) = 1.0 + 0.1 * static_cast<double>(i % 7);
  }
  return rhs;
}
}

TEST(LinearSolver, TakesMatricesOfItsPatternHoweverTheyAreStored)
{
  for (Method method : bothMethods)
  {
    // The lower triangle alone, all of it, and with room between its columns.
    const SparseMatrix whole = gridLaplacian(13).selfadjointView<Eigen::Lower>();
    const SparseMatrix lower = whole.triangularView<Eigen::Lower>();
    const Eigen::MatrixXd right = someRightHandSide(whole.rows());
    for (const SparseMatrix& matrix : { lower, whole })
    {
      LinearSolver solver = make(method, matrix.rows());
      ASSERT_TRUE(solver.factorize(matrix));
      const Eigen::MatrixXd once = solver.solve(right);
      EXPECT_LT((whole * once - right).norm(), 1e-12 * right.norm());
      SparseMatrix doubled = 2.0 * matrix;
      doubled.reserve(Eigen::VectorXi::Constant(matrix.cols(), 9));
      ASSERT_FALSE(doubled.isCompressed());
      ASSERT_TRUE(solver.factorize(doubled));
      EXPECT_LT((2.0 * solver.solve(right) - once).norm(), 1e-12 * once.norm());
      EXPECT_FALSE(solver.factorize(matrix.nonZeros() < whole.nonZeros() ? whole : lower));
      EXPECT_FALSE(solver.ok());
    }
  }
}

TEST(LinearSolver, OneStepOfRefinementTakesTheRegularizationOut)
{
  const SparseMatrix exact = saddlePoint(10, 20, 0.0, 11);
  const SparseMatrix regularized = saddlePoint(10, 20, 1e-6, 11);
  const Eigen::MatrixXd rhs = someRightHandSide(exact.rows());
  LinearSolver solver;
  ASSERT_TRUE(solver.factorize(regularized));
  const double before = (exact * solver.solve(rhs) - rhs).norm();
  const double after = (exact * solver.solveRefined(exact, rhs) - rhs).norm();
  EXPECT_GT(before, 1e-8);
  EXPECT_LT(after, 1e-4 * before);
}

TEST(LinearSolver, RefusesWhatItCannotFactor)
{
  SparseMatrix singular = gridLaplacian(4);
  for (Eigen::Index k = 0; k < singular.cols(); ++k)
  {
    singular.coeffRef(k, 5) = 0.0;
    singular.coeffRef(5, k) = 0.0;
  }
  singular.prune(0.0);
  SparseMatrix notFinite = gridLaplacian(4);
  notFinite.coeffRef(3, 3) = std::numeric_limits<double>::quiet_NaN();
  SparseMatrix rectangular(4, 5);
  SparseMatrix empty(16, 16);
  for (Method method : bothMethods)
  {
    for (const SparseMatrix* matrix : { &singular, &empty, &notFinite, &rectangular })
    {
      LinearSolver solver = make(method, 16);
      EXPECT_FALSE(solver.factorize(*matrix)) << static_cast<int>(method);
      EXPECT_FALSE(solver.ok());
      const Eigen::MatrixXd nothing = solver.solve(Eigen::MatrixXd::Ones(16, 1));
      EXPECT_EQ(nothing.rows(), 0);
      EXPECT_EQ(nothing.cols(), 1); // without a column none of Eigen's vectors can be made of it
      EXPECT_EQ(solver.positive(), none);
    }
  }
  for (const SparseMatrix* matrix : { &singular, &empty, &notFinite, &rectangular })
  {
    EXPECT_FALSE(SuperLUFactorization().factorize(*matrix));
  }
}

TEST(LinearSolver, SolvesTheEmptySystem)
{
  LinearSolver solver;
  EXPECT_TRUE(solver.factorize(SparseMatrix(0, 0)));
  EXPECT_EQ(solver.negative(), 0);
  EXPECT_EQ(solver.solve(Eigen::MatrixXd(0, 2)).rows(), 0);
}

TEST(LinearSolver, ConstraintsBehindTheirUnknownsKeepTheirDigits)
{
  // Pivots of -1e-12 would leave four.
  const int side = 12;
  const SparseMatrix matrix = saddlePoint(side, 40, 1e-12, 7);
  const Eigen::MatrixXd rhs = someRightHandSide(matrix.rows());
  LinearSolver solver(LeadingColumns{ side * side });
  ASSERT_TRUE(solver.factorize(matrix));
  EXPECT_EQ(solver.negative(), 40);
  EXPECT_LT((matrix * solver.solve(rhs) - rhs).norm(), 1e-11 * rhs.norm());
}

TEST(LinearSolver, LeastNormIsTheShortestSolutionOfDependentRowsAndDividesContradictions)
{
  // x + y = 2 twice, once doubled: of (2 - t, t) the shortest is (1, 1).
  const Eigen::MatrixXd dependent{ { 1.0, 1.0 }, { 2.0, 2.0 } };
  const Eigen::VectorXd shortest = leastNormSolution(dependent, Eigen::Vector2d(2.0, 4.0));
  EXPECT_LT((shortest - Eigen::Vector2d(1.0, 1.0)).norm(), 1e-14);
  // x = 1 and x = 4: their mean, and nothing of y.
  const Eigen::MatrixXd contradictory{ { 1.0, 0.0 }, { 1.0, 0.0 } };
  const Eigen::VectorXd mean = leastNormSolution(contradictory, Eigen::Vector2d(1.0, 4.0));
  EXPECT_LT((mean - Eigen::Vector2d(2.5, 0.0)).norm(), 1e-14);
}

namespace
{
/// A matrix with the graph's pattern, and its lower triangle.
struct System
{
  Eigen::MatrixXd dense;
  SparseMatrix lower;
};

/// \param negative of this number of diagonal blocks one is negative: the matrix is then quasi-definite, for
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

namespace
{
/// Two unknowns a vertex of a mesh in the plane, and constraints on some edges with a small block:
/// the pattern of the isometric scheme's systems.
struct KktSystem
{
  Eigen::SparseMatrix<double> matrix; ///< lower triangle
  Dissection order;
};

KktSystem kktSystem(Index side)
{
  const Surface surface = flatPatch(side, side);
  const Triangles& triangles = surface.mesh.triangles();
  const Index vertices = surface.mesh.vertexCount();
  std::vector<Eigen::Triplet<double>> entries;
  for (const Triangle& t : triangles)
  {
    for (int a = 0; a < 6; ++a)
    {
      for (int b = 0; b <= a; ++b)
      {
        const Index row = 2 * t[a / 2] + a % 2;
        const Index column = 2 * t[b / 2] + b % 2;
        entries.emplace_back(std::max(row, column), std::min(row, column),
          row == column ? 4.0 : 0.3 * std::sin(double(row + 2 * column)));
      }
    }
  }
  KktSystem system;
  const Dissection dissection = dissect(triangles, surface.mesh.points());
  system.order = dissection.replaced([&](Index k, Indices& order) {
    order.push_back(2 * dissection.order[k]);
    order.push_back(2 * dissection.order[k] + 1);
  });
  Index row = 2 * vertices;
  for (std::size_t t = 0; t < triangles.size(); t += 5, ++row)
  {
    entries.emplace_back(row, 2 * triangles[t][0], 1.0);
    entries.emplace_back(row, 2 * triangles[t][1] + 1, -0.5);
    entries.emplace_back(row, row, -1e-8);
    system.order.order.push_back(row);
  }
  system.order.endRange(static_cast<Index>(system.order.order.size()));
  system.matrix.resize(row, row);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
}
}

TEST(MultifrontalFactorization, IsTheSameToTheLastBitForAnyNumberOfThreads)
{
  const KktSystem system = kktSystem(60);
  const Eigen::MatrixXd rhs = Eigen::MatrixXd::Ones(system.matrix.rows(), 1);
  for (const FactorPrecision precision : { FactorPrecision::Double, FactorPrecision::Single })
  {
    MultifrontalFactorization factorization(precision);
    factorization.analyze(system.matrix, system.order);
    ASSERT_TRUE(factorization.factorize(system.matrix, {}));
    const Eigen::MatrixXd alone = factorization.solve(rhs);
    for (Index count : { 2, 3, 8 })
    {
      ASSERT_TRUE(factorization.factorize(system.matrix, withThreads(count)));
      EXPECT_EQ((factorization.solve(rhs) - alone).cwiseAbs().maxCoeff(), 0.0) << count;
    }
  }
}

TEST(MultifrontalFactorization, KeptInSinglePrecisionTakesHalfTheMemoryAndRefinesToTheSameSolution)
{
  const KktSystem system = kktSystem(60);
  const std::size_t count = SupernodalStructure(system.matrix, system.order).factorSize();
  Execution enoughForSingle;
  enoughForSingle.factorMemory = count * sizeof(float);
  MultifrontalFactorization factorization;
  factorization.analyze(system.matrix, system.order);
  EXPECT_THROW(factorization.factorize(system.matrix, enoughForSingle), std::bad_alloc);
  factorization.setPrecision(FactorPrecision::Single);
  ASSERT_TRUE(factorization.factorize(system.matrix, enoughForSingle));

  const Eigen::VectorXd rhs = Eigen::VectorXd::Ones(system.matrix.rows());
  const auto left = [&](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(rhs - system.matrix.selfadjointView<Eigen::Lower>() * x);
  };
  Eigen::VectorXd x = factorization.solve(rhs);
  const double first = left(x).cwiseAbs().maxCoeff();
  EXPECT_LT(first, 1e-4);
  EXPECT_GT(first, 1e-9) << "not kept in single precision";
  for (int refinement = 0; refinement < 3; ++refinement)
  {
    x += factorization.solve(left(x));
  }
  EXPECT_LT(left(x).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(MultifrontalFactorization, IsNoneInSinglePrecisionWhereItsNumbersAreTooLarge)
{
  Eigen::SparseMatrix<double> matrix(2, 2);
  matrix.insert(0, 0) = 1e-35;
  matrix.insert(1, 0) = 1.0;
  matrix.insert(1, 1) = 1.0;
  matrix.makeCompressed();
  Dissection order;
  order.order = { 0, 1 };
  order.end = { 2 };
  MultifrontalFactorization factorization(FactorPrecision::Single);
  factorization.analyze(matrix, order);
  EXPECT_FALSE(factorization.factorize(matrix, {}));
  factorization.setPrecision(FactorPrecision::Double);
  EXPECT_TRUE(factorization.factorize(matrix, {}));
}

TEST(MultifrontalFactorization, DissectionFillsInLessThanTheOrderOfTheMesh)
{
  const KktSystem system = kktSystem(60);
  Dissection given;
  given.order.resize(system.order.order.size());
  std::iota(given.order.begin(), given.order.end(), 0);
  given.end.resize(given.order.size());
  std::iota(given.end.begin(), given.end.end(), 1);
  Indices sorted = system.order.order;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, given.order) << "an order names each column once";
  EXPECT_LT(SupernodalStructure(system.matrix, system.order).factorSize(),
    SupernodalStructure(system.matrix, given).factorSize() / 2);
}

TEST(NestedDissection, PutsASmallSeparatorThatDividesTheMeshLast)
{
  const Surface surface = flatPatch(40, 30);
  const Triangles& triangles = surface.mesh.triangles();
  const Index count = surface.mesh.vertexCount();
  for (const Dissection& dissection :
    { dissect(triangles, surface.mesh.points()), dissect(triangles, count) })
  {
    Indices sorted = dissection.order;
    std::sort(sorted.begin(), sorted.end());
    Indices all(count);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all) << "each vertex once";
    ASSERT_GE(dissection.end.size(), 2U);
    EXPECT_TRUE(std::is_sorted(dissection.end.begin(), dissection.end.end()));
    EXPECT_EQ(
      std::adjacent_find(dissection.end.begin(), dissection.end.end()), dissection.end.end());
    EXPECT_EQ(dissection.end.back(), count);
    const Index begin = dissection.end[dissection.end.size() - 2];
    EXPECT_LT(count - begin, 100) << "of 1271 vertices";
    // Without it no part that hangs together has many more than half of the others.
    std::vector<char> separates(count, 0);
    for (Index k = begin; k < count; ++k)
    {
      separates[dissection.order[k]] = 1;
    }
    JoinedSets parts(count);
    for (const Triangle& t : triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (!separates[t[k]] && !separates[t[(k + 1) % 3]])
        {
          parts.join(t[k], t[(k + 1) % 3]);
        }
      }
    }
    Indices size(count, 0);
    for (Index v = 0; v < count; ++v)
    {
      size[parts.find(v)] += separates[v] ? 0 : 1;
    }
    EXPECT_LT(*std::max_element(size.begin(), size.end()), 0.65 * count);
  }
}
