// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace flattening
{
/// Raises no floating-point exception, unlike Eigen's allFinite(), which subtracts (version 3.4) or
/// compares (5.0) numbers that are none.
template <typename Derived>
bool isFinite(const Eigen::DenseBase<Derived>& values)
{
  for (Eigen::Index column = 0; column < values.cols(); ++column)
  {
    for (Eigen::Index row = 0; row < values.rows(); ++row)
    {
      if (!std::isfinite(values.derived().coeff(row, column)))
      {
        return false;
      }
    }
  }
  return true;
}
}
