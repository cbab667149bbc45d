// SPDX-License-Identifier: BSD-3-Clause
#include "Base/ConvexPart.h"

#include <gtest/gtest.h>

using namespace flattening;

TEST(ConvexPart, IsTheSameWhereNoEigenvalueIsNegative)
{
  Eigen::Matrix3d matrix;
  matrix << 2.0, -1.0, 0.1, -1.0, 2.0, 0.3, 0.1, 0.3, 5.0;
  EXPECT_EQ(withoutNegativeEigenvalues(matrix), matrix);
  EXPECT_EQ(
    withoutNegativeEigenvalues(Eigen::Matrix2d(Eigen::Matrix2d::Zero())), Eigen::Matrix2d::Zero());
}

/// A rotated diagonal whose signs are known.
TEST(ConvexPart, HasZeroForEachNegativeEigenvalueAlongTheSameAxis)
{
  const double c = 0.6;
  const double s = 0.8;
  Eigen::Matrix4d axes = Eigen::Matrix4d::Identity();
  axes.topLeftCorner<2, 2>() << c, -s, s, c;
  axes.bottomRightCorner<2, 2>() << s, -c, c, s;
  const Eigen::Vector4d values(3.0, -2.0, -0.5, 7.0);
  const Eigen::Matrix4d matrix = axes * values.asDiagonal() * axes.transpose();
  const Eigen::Matrix4d expected =
    axes * Eigen::Vector4d(3.0, 0.0, 0.0, 7.0).asDiagonal() * axes.transpose();
  EXPECT_LT((withoutNegativeEigenvalues(matrix) - expected).norm(), 1e-14);
}
