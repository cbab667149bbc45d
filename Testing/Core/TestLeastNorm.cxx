// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/LeastNorm.h"

#include <gtest/gtest.h>

using namespace flattening;

/// x + y = 2 twice, once doubled: of (2 - t, t) the shortest is (1, 1).
TEST(LeastNorm, IsTheShortestSolutionWhereRowsDependOnEachOther)
{
  Eigen::MatrixXd matrix(2, 2);
  matrix << 1.0, 1.0, 2.0, 2.0;
  const Eigen::VectorXd x = leastNormSolution(matrix, Eigen::Vector2d(2.0, 4.0));
  EXPECT_LT((x - Eigen::Vector2d(1.0, 1.0)).norm(), 1e-14);
}

/// x = 1 and x = 4: their mean, and nothing of y.
TEST(LeastNorm, DividesWhatContradictsItself)
{
  Eigen::MatrixXd matrix(2, 2);
  matrix << 1.0, 0.0, 1.0, 0.0;
  const Eigen::VectorXd x = leastNormSolution(matrix, Eigen::Vector2d(1.0, 4.0));
  EXPECT_LT((x - Eigen::Vector2d(2.5, 0.0)).norm(), 1e-14);
}
