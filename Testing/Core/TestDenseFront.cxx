// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/DenseFront.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>

using namespace flattening;

namespace
{
Eigen::MatrixXd waves(Index rows, Index columns, double phase)
{
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [=](Eigen::Index i, Eigen::Index j) {
    return std::sin(1.3 * static_cast<double>(i) + 0.7 * static_cast<double>(j) + phase);
  });
}
}

TEST(DenseProduct, IsThePlainProductForMatricesOfEveryShape)
{
  // Around the sizes of its tiles and blocks.
  for (const Index rows : { 1, 3, 7, 8, 9, 63, 64, 65, 130 })
  {
    for (const Index columns : { 1, 3, 4, 5, 23, 24, 64, 65, 130 })
    {
      for (const Index depth : { 1, 2, 5, 95, 96, 97, 200 })
      {
        const Eigen::MatrixXd left = waves(rows, depth, 0.1);
        const Eigen::MatrixXd right = waves(columns, depth, 0.2);
        const Eigen::VectorXd diagonal = waves(depth, 1, 0.4);
        const Eigen::MatrixXd before = waves(rows, columns, 0.3);
        const Eigen::MatrixXd expected = before - left * diagonal.asDiagonal() * right.transpose();
        for (const bool lower : { false, true })
        {
          Eigen::MatrixXd to = before;
          subtractProduct(
            { to.data(), std::size_t(rows), rows, columns, { left.data(), std::size_t(rows) },
              { right.data(), std::size_t(columns) }, diagonal.data(), depth, lower });
          Eigen::MatrixXd difference = to - expected;
          if (lower)
          {
            difference = Eigen::MatrixXd(difference.triangularView<Eigen::Lower>());
          }
          EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-13 * (1 + depth))
            << rows << " x " << columns << ", " << depth;
        }
      }
    }
  }
}

TEST(DenseProduct, GivesTheSameBitsWhereverTheMatrixIsDivided)
{
  constexpr Index size = 150;
  constexpr Index depth = 40;
  const Eigen::MatrixXd factor = waves(size, depth, 0.1);
  const Eigen::VectorXd diagonal = waves(depth, 1, 0.4);
  const DenseColumns columns{ factor.data(), size };
  Eigen::MatrixXd whole = waves(size, size, 0.3);
  Eigen::MatrixXd parts = whole;
  subtractProduct(
    { whole.data(), size, size, size, columns, columns, diagonal.data(), depth, false });
  for (Index begin = 0; begin < size; begin += 37)
  {
    const Index width = std::min<Index>(37, size - begin);
    subtractProduct({ parts.col(begin).data(), size, size, width, columns,
      { factor.data() + begin, size }, diagonal.data(), depth, false });
  }
  EXPECT_EQ(whole, parts);
}
