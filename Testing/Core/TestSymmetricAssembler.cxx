// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/SymmetricAssembler.h"

#include <gtest/gtest.h>

using namespace flattening;

TEST(SparseBlocks, AddUpToTheMatrixThatDenseOnesMake)
{
  // Blocks that overlap, one with unknowns in falling order, and rows below all of them.
  SymmetricAssembler assembler(8);
  const SymmetricBlock<3> three(assembler, { 4, 0, 2 });
  const SymmetricBlock<2> two(assembler, { 2, 4 });
  const JacobianBlock<2, 3> rows(assembler, 6, { 5, 0, 2 });
  const DiagonalBlock diagonal(assembler, 3, 5);
  assembler.finish();

  Eigen::Matrix3d a;
  a << 1.0, 2.0, 3.0, 2.0, 5.0, 6.0, 3.0, 6.0, 9.0;
  Eigen::Matrix2d b;
  b << 10.0, 20.0, 20.0, 30.0;
  Eigen::Matrix<double, 2, 3> j;
  j << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(8, 8);
  const Index u3[] = { 4, 0, 2 };
  const Index u2[] = { 2, 4 };
  const Index uj[] = { 5, 0, 2 };
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      expected(u3[r], u3[c]) += a(r, c);
    }
    for (int row = 0; row < 2; ++row)
    {
      expected(6 + row, uj[r]) += j(row, r);
      expected(uj[r], 6 + row) += j(row, r);
    }
  }
  for (int r = 0; r < 2; ++r)
  {
    for (int c = 0; c < 2; ++c)
    {
      expected(u2[r], u2[c]) += b(r, c);
    }
  }
  for (Index k = 0; k < 5; ++k)
  {
    expected(3 + k, 3 + k) += 100.0 * k;
  }

  // The second filling finds nothing of the first.
  for (int filling = 0; filling < 2; ++filling)
  {
    assembler.clear();
    three.add(assembler, a);
    two.add(assembler, b);
    rows.add(assembler, j);
    for (Index k = 0; k < 5; ++k)
    {
      diagonal.add(assembler, k, 100.0 * k);
    }
    const Eigen::MatrixXd filled(
      Eigen::MatrixXd(assembler.matrix()).selfadjointView<Eigen::Lower>());
    EXPECT_LT((filled - expected).cwiseAbs().maxCoeff(), 1e-14);
  }
  Eigen::VectorXd product = Eigen::VectorXd::Zero(8);
  const Eigen::Vector2d multipliers(2.0, -3.0);
  rows.addTransposedTimes(j, multipliers, product);
  EXPECT_LT((product - expected.topRightCorner(8, 2) * multipliers).head(6).norm(), 1e-14);
}

TEST(SparseBlocks, WhatIsNoUnknownHasNoEntries)
{
  SymmetricAssembler assembler(4);
  const SymmetricBlock<3> block(assembler, { none, 1, none });
  const JacobianBlock<1, 2> row(assembler, 3, { none, 1 });
  const SymmetricBlock<2> nothing(assembler, { none, none });
  assembler.finish();
  assembler.clear();
  block.add(assembler, Eigen::Matrix3d(Eigen::Matrix3d::Constant(7.0)));
  row.add(assembler, Eigen::RowVector2d(5.0, 6.0));
  nothing.add(assembler, Eigen::Matrix2d(Eigen::Matrix2d::Identity()));
  EXPECT_EQ(assembler.matrix().nonZeros(), 2);
  EXPECT_EQ(assembler.matrix().coeff(1, 1), 7.0);
  EXPECT_EQ(assembler.matrix().coeff(3, 1), 6.0);
  Eigen::VectorXd whole = Eigen::VectorXd::Zero(4);
  block.scatter(Eigen::Vector3d(1.0, 2.0, 3.0), whole);
  EXPECT_EQ(whole, Eigen::VectorXd(Eigen::Vector4d(0.0, 2.0, 0.0, 0.0)));
}

TEST(SparseBlocks, OfPointsAddUpToTheMatrixThatDenseOnesMakeInEveryOrderOfTheirVertices)
{
  using Block = PointsBlock<3>;
  Eigen::Matrix<double, 6, 6> a;
  for (int r = 0; r < 6; ++r)
  {
    for (int c = 0; c <= r; ++c)
    {
      a(r, c) = a(c, r) = 1.0 + 10.0 * r + c;
    }
  }
  const std::array<Block::Vertices, 4> triangles{ Block::Vertices{ 0, 1, 2 }, { 2, 1, 3 },
    { 3, 0, 2 }, { 1, 3, 0 } };
  SymmetricAssembler assembler(8);
  Index first = none;
  for (const Block::Vertices& v : triangles)
  {
    const Index here = Block::declare(assembler, v);
    first = first == none ? here : first;
  }
  assembler.finish();
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(8, 8);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(8);
  Eigen::VectorXd scattered = Eigen::VectorXd::Zero(8);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Block::Vertices& v = triangles[t];
    Block::add(assembler, first + static_cast<Index>(t) * Block::entryCount, v, a);
    Block::scatter(v, a.col(0), scattered);
    for (int r = 0; r < 6; ++r)
    {
      sum[2 * v[r / 2] + r % 2] += a(r, 0);
      for (int c = 0; c < 6; ++c)
      {
        expected(2 * v[r / 2] + r % 2, 2 * v[c / 2] + c % 2) += a(r, c);
      }
    }
  }
  const Eigen::MatrixXd filled(Eigen::MatrixXd(assembler.matrix()).selfadjointView<Eigen::Lower>());
  EXPECT_LT((filled - expected).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(scattered, sum);
}
