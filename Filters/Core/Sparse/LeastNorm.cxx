// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/LeastNorm.h"

#include <Eigen/QR>

namespace flattening
{
//------------------------------------------------------------------------------
Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right)
{
  return matrix.completeOrthogonalDecomposition().solve(right);
}
}
