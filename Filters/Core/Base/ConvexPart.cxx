// SPDX-License-Identifier: BSD-3-Clause
#include "Base/ConvexPart.h"

#include <Eigen/Eigenvalues>

#include <cmath>

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

Eigen::Matrix2d withoutNegativeEigenvalues(const Eigen::Matrix2d& matrix)
{
  const double mean = 0.5 * (matrix(0, 0) + matrix(1, 1));
  const double half = 0.5 * (matrix(0, 0) - matrix(1, 1));
  const double radius = std::hypot(half, matrix(0, 1));
  if (mean >= radius)
  {
    return matrix;
  }
  if (mean <= -radius)
  {
    return Eigen::Matrix2d::Zero();
  }
  const double cosine = half / radius;
  const double sine = matrix(0, 1) / radius;
  Eigen::Matrix2d projector;
  projector << 1.0 + cosine, sine, sine, 1.0 - cosine;
  return 0.5 * (mean + radius) * projector;
}

template Eigen::Matrix3d withoutNegativeEigenvalues<3>(const Eigen::Matrix3d& matrix);
template Eigen::Matrix4d withoutNegativeEigenvalues<4>(const Eigen::Matrix4d& matrix);
}
