// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/SpaceMatrix.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

using namespace flattening;

namespace
{
Eigen::Matrix3d blockOf(int seed)
{
  Eigen::Matrix3d block;
  for (int k = 0; k < 9; ++k)
  {
    block(k / 3, k % 3) = seed + 0.1 * k;
  }
  return block;
}

Eigen::MatrixXd dense(const SpaceMatrix& matrix)
{
  return Eigen::MatrixXd(Eigen::MatrixXd(matrix.matrix()).selfadjointView<Eigen::Lower>());
}
}

TEST(SpaceMatrix, AddsUpToTheMatrixThatDenseOnesMake)
{
  // Five vertices; 0 and 3 are coupled by their axes, the second time in full.
  const std::vector<std::pair<Index, Index>> full{ { 0, 1 }, { 4, 1 }, { 2, 1 }, { 3, 0 } };
  const std::vector<std::pair<Index, Index>> axes{ { 0, 3 }, { 4, 0 }, { 2, 3 } };
  SpaceMatrix matrix(15);
  for (const auto& [a, b] : axes)
  {
    matrix.coupleAxes(3 * a, 3 * b);
    matrix.coupleAxes(3 * b, 3 * a);
  }
  for (const auto& [a, b] : full)
  {
    matrix.couple(3 * a, 3 * b);
  }
  matrix.finish();
  for (int time = 0; time < 2; ++time)
  {
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(15, 15);
    matrix.clear();
    int seed = 0;
    for (const auto& [a, b] : full)
    {
      const Eigen::Matrix3d block = blockOf(++seed);
      matrix.addPair(3 * a, 3 * b, block);
      expected.block<3, 3>(3 * a, 3 * b) += block;
      expected.block<3, 3>(3 * b, 3 * a) += block.transpose();
    }
    for (const auto& [a, b] : axes)
    {
      const double value = ++seed;
      matrix.addPair(3 * a, 3 * b, value);
      expected.block<3, 3>(3 * a, 3 * b).diagonal().array() += value;
      expected.block<3, 3>(3 * b, 3 * a).diagonal().array() += value;
    }
    const Eigen::Matrix3d own = blockOf(7) + blockOf(7).transpose();
    matrix.addOwn(6, own);
    expected.block<3, 3>(6, 6) += own;
    matrix.shift(0.5);
    expected.diagonal().array() += 0.5;
    EXPECT_EQ(dense(matrix), expected);
  }
  // Six entries a vertex, nine a full pair, three one of axes.
  EXPECT_EQ(matrix.matrix().nonZeros(), 5 * 6 + 4 * 9 + 2 * 3);
}

TEST(SpaceMatrix, APairOfAVertexWithItselfIsABlockAndItsTranspose)
{
  SpaceMatrix matrix(3);
  matrix.couple(0, 0);
  matrix.finish();
  matrix.addPair(0, 0, blockOf(1));
  matrix.addPair(0, 0, 2.0);
  EXPECT_EQ(dense(matrix),
    Eigen::MatrixXd(blockOf(1) + blockOf(1).transpose() + 4.0 * Eigen::Matrix3d::Identity()));
}

TEST(SpaceMatrix, WhatIsHeldHasNoEntries)
{
  SpaceMatrix matrix(6);
  matrix.couple(none, 3);
  matrix.coupleAxes(0, none);
  matrix.finish();
  matrix.addPair(none, 3, blockOf(1));
  matrix.addPair(0, none, 2.0);
  matrix.addOwn(none, blockOf(1));
  EXPECT_EQ(matrix.matrix().nonZeros(), 12);
  EXPECT_EQ(dense(matrix), Eigen::MatrixXd::Zero(6, 6));
}
