// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace flattening
{
/// The nearest positive semidefinite matrix to a symmetric one: the same where it has no negative
/// eigenvalue, otherwise with zeros in their place. N is 3 or 4.
template <int N>
Eigen::Matrix<double, N, N> withoutNegativeEigenvalues(const Eigen::Matrix<double, N, N>& matrix);

Eigen::Matrix2d withoutNegativeEigenvalues(const Eigen::Matrix2d& matrix);

extern template Eigen::Matrix3d withoutNegativeEigenvalues<3>(const Eigen::Matrix3d& matrix);
extern template Eigen::Matrix4d withoutNegativeEigenvalues<4>(const Eigen::Matrix4d& matrix);
}
