// SPDX-License-Identifier: BSD-3-Clause
#include "Base/ConvexPart.h"

#include <Eigen/Eigenvalues>

namespace flattening
{
template <int N>
Eigen::Matrix<double, N, N> withoutNegativeEigenvalues(const Eigen::Matrix<double, N, N>& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(matrix);
  if (solver.eigenvalues()[0] >= 0.0)
  {
    return matrix;
  }
  const Eigen::Matrix<double, N, 1> kept = solver.eigenvalues().cwiseMax(0.0);
  return solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
}

template Eigen::Matrix2d withoutNegativeEigenvalues<2>(const Eigen::Matrix2d& matrix);
template Eigen::Matrix3d withoutNegativeEigenvalues<3>(const Eigen::Matrix3d& matrix);
template Eigen::Matrix4d withoutNegativeEigenvalues<4>(const Eigen::Matrix4d& matrix);
}
