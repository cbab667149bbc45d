// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace flattening
{
/// Of all x for which |matrix x - right| is least the shortest, by a complete orthogonal
/// decomposition: rows may depend on each other and contradict each other.
Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
}
