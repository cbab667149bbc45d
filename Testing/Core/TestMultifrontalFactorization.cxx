// SPDX-License-Identifier: BSD-3-Clause
#include "Base/CompressedRows.h"
#include "Sparse/MultifrontalFactorization.h"
#include "Sparse/NestedDissection.h"
#include "TestGraphs.h"
#include "TestMeshes.h"

using namespace flattening;
using namespace testmeshes;

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

namespace
{
void expectOrderInRanges(const Dissection& dissection, Index count)
{
  Indices sorted = dissection.order;
  std::sort(sorted.begin(), sorted.end());
  Indices all(count);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all) << "each vertex once";
  ASSERT_FALSE(dissection.end.empty());
  EXPECT_TRUE(std::is_sorted(dissection.end.begin(), dissection.end.end()));
  EXPECT_EQ(std::adjacent_find(dissection.end.begin(), dissection.end.end()), dissection.end.end());
  EXPECT_EQ(dissection.end.back(), count);
}
}

TEST(NestedDissection, PutsASmallSeparatorThatDividesTheMeshLast)
{
  const Surface surface = flatPatch(40, 30);
  const Triangles& triangles = surface.mesh.triangles();
  const Index count = surface.mesh.vertexCount();
  for (const Dissection& dissection :
    { dissect(triangles, surface.mesh.points()), dissect(triangles, count) })
  {
    expectOrderInRanges(dissection, count);
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

TEST(NestedDissection, EndsWithEachVertexOnceForGraphsOfEveryShape)
{
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  const std::vector<testgraphs::Graph> graphs = testgraphs::graphs();
  ASSERT_GT(graphs.size(), 50U);
  for (const testgraphs::Graph& graph : graphs)
  {
    SCOPED_TRACE(graph.name);
    expectOrderInRanges(dissect(graph.cliques, graph.count), graph.count);
    Points3 positions(graph.count);
    std::generate(positions.begin(), positions.end(),
      [&] { return Point3(place(generator), place(generator), 0.0); });
    expectOrderInRanges(dissect(graph.cliques, positions), graph.count);
  }
}
