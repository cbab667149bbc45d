// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/FactorBlocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace flattening;

namespace
{
/// The columns of a front, ones on the diagonal, with numbers above it that do not count.
template <typename Value>
Eigen::Matrix<Value, Eigen::Dynamic, Eigen::Dynamic> columnsOf(Index size, Index columns)
{
  return Eigen::Matrix<Value, Eigen::Dynamic, Eigen::Dynamic>::NullaryExpr(
    size, columns, [](Eigen::Index i, Eigen::Index j) {
      const auto wave = static_cast<Value>(
        0.3 * std::sin(1.3 * static_cast<double>(i) + 0.7 * static_cast<double>(j)));
      return i == j ? Value(1) : wave;
    });
}

/// The columns one after the other, each from the first row of its panel on.
template <typename Value>
std::vector<Value> keptOf(const Eigen::Matrix<Value, Eigen::Dynamic, Eigen::Dynamic>& columns)
{
  std::vector<Value> kept;
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
  {
    const Eigen::Index first = k - k % FactorColumns<Value>::panelWidth;
    kept.insert(kept.end(), columns.col(k).begin() + first, columns.col(k).end());
  }
  return kept;
}

/// The whole triangle, the identity below the columns.
template <typename Value>
Eigen::MatrixXd triangleOf(const Eigen::Matrix<Value, Eigen::Dynamic, Eigen::Dynamic>& columns)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(columns.rows(), columns.rows());
  result.leftCols(columns.cols()) =
    columns.template cast<double>().template triangularView<Eigen::Lower>();
  return result;
}

template <typename Value>
void expectSolves()
{
  // Around the widths of its panels and vectors.
  for (const Index columns : { 1, 3, 4, 5, 8, 13 })
  {
    for (const Index rows : { 0, 1, 3, 4, 7, 8, 9, 17, 40 })
    {
      const Index size = columns + rows;
      const auto values = columnsOf<Value>(size, columns);
      const std::vector<Value> kept = keptOf<Value>(values);
      const FactorColumns<const Value> front{ kept.data(), size, columns };
      const Eigen::MatrixXd triangle = triangleOf<Value>(values);
      const Eigen::MatrixXd before = Eigen::MatrixXd::NullaryExpr(size, 2,
        [](Eigen::Index i, Eigen::Index j) { return std::cos(double(i) + 2.0 * double(j)); });
      const auto mapped = [size](Eigen::MatrixXd& w) {
        return FrontVectors(w.data(), size, w.cols(), Eigen::OuterStride<>(w.rows()));
      };
      Eigen::MatrixXd w = before;
      substituteForward(front, mapped(w));
      EXPECT_LT((triangle * w - before).cwiseAbs().maxCoeff(), 1e-13) << size << ", " << columns;
      w = before;
      substituteBackward(front, mapped(w));
      EXPECT_LT((triangle.transpose() * w - before).cwiseAbs().maxCoeff(), 1e-13)
        << size << ", " << columns;
    }
  }
}
}

TEST(DenseSubstitution, SolvesWithTheTriangleAndWithItsTransposeForFrontsOfEveryShape)
{
  expectSolves<double>();
}

TEST(DenseSubstitution, LosesNothingByFactorsOfSinglePrecisionButTheirOwnRounding)
{
  expectSolves<float>();
}
