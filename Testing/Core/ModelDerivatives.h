// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/NewtonKktStep.h"

#include <gtest/gtest.h>

#include <functional>

namespace testmeshes
{
using namespace flattening;

/// Central differences of a function of the unknowns, one after the other.
/// \param each gets an unknown, and the places a step above and below it.
inline void forEachUnknown(const Eigen::VectorXd& x, double step,
  const std::function<void(Index, const Eigen::VectorXd&, const Eigen::VectorXd&)>& each)
{
  for (Index k = 0; k < static_cast<Index>(x.size()); ++k)
  {
    Eigen::VectorXd up = x;
    Eigen::VectorXd down = x;
    up[k] += step;
    down[k] -= step;
    each(k, up, down);
  }
}

/// The gradient at x is that of the objective, as a fraction of one more than a slope.
inline void expectGradientOfObjective(
  NewtonKktModel& model, const Eigen::VectorXd& x, double step, double tolerance)
{
  const Eigen::VectorXd free = Eigen::VectorXd::Zero(model.constraintCount());
  const Eigen::VectorXd gradient = model.linearize(x, free, Curvature::Exact, 0.0, {}).gradient;
  forEachUnknown(x, step, [&](Index k, const Eigen::VectorXd& up, const Eigen::VectorXd& down) {
    const double slope = (model.objective(up, {}) - model.objective(down, {})) / (2.0 * step);
    EXPECT_NEAR(gradient[k], slope, tolerance * (1.0 + std::abs(slope)));
  });
}

/// The exact Hessian at x of a model without constraints is that of its gradient.
inline void expectHessianOfGradient(
  NewtonKktModel& model, const Eigen::VectorXd& x, double step, double tolerance)
{
  const auto gradientAt = [&model](const Eigen::VectorXd& place) {
    return model.linearize(place, {}, Curvature::Exact, 0.0, {}).gradient;
  };
  gradientAt(x);
  const Eigen::MatrixXd hessian(SparseMatrix(model.kkt().selfadjointView<Eigen::Lower>()));
  forEachUnknown(x, step, [&](Index k, const Eigen::VectorXd& up, const Eigen::VectorXd& down) {
    const Eigen::VectorXd bend = (gradientAt(up) - gradientAt(down)) / (2.0 * step);
    EXPECT_LT((hessian.col(k) - bend).norm(), tolerance * (1.0 + bend.norm()));
  });
}
}
