// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Embedding/DistortionEnergy.h"
#include "Sparse/NewtonKktStep.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

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

/// Gradient and Hessian of a density at the parts of a map are those of central differences.
/// \param bendStep that for the Hessian
inline void expectDensityDerivatives(
  const std::function<DistortionEnergyValue(const Eigen::Vector4d&)>& evaluate,
  const Eigen::Vector4d& parts, double step, double bendStep, double tolerance)
{
  const DistortionEnergyValue value = evaluate(parts);
  for (int k = 0; k < 4; ++k)
  {
    const Eigen::Vector4d d = Eigen::Vector4d::Unit(k);
    const double rise = evaluate(parts + step * d).value - evaluate(parts - step * d).value;
    EXPECT_NEAR(value.gradient[k], rise / (2.0 * step), tolerance);
    const Eigen::Vector4d bend =
      evaluate(parts + bendStep * d).gradient - evaluate(parts - bendStep * d).gradient;
    EXPECT_LT((value.hessian.col(k) - bend / (2.0 * bendStep)).norm(), tolerance);
  }
}

/// The nearest matrix without negative eigenvalues.
inline Eigen::Matrix4d nearestConvex(const Eigen::Matrix4d& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(matrix);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
    solver.eigenvectors().transpose();
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

/// The KKT matrix at x holds the Hessian of the Lagrangian and the Jacobian of the constraints.
/// \param hessian, jacobian tolerances, of one more than the norm of a column
/// \param isGauge unknowns whose columns also keep the whole from moving
inline void expectKktOfLagrangian(NewtonKktModel& model, const Eigen::VectorXd& x,
  const Eigen::VectorXd& multipliers, double step, double hessian, double jacobian,
  const std::function<bool(Index)>& isGauge = {})
{
  const auto slope = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    const auto linear = model.linearize(at, multipliers, Curvature::Exact, 0.0, {});
    return linear.gradient + model.transposedJacobianTimes(multipliers);
  };
  slope(x);
  const Eigen::MatrixXd kkt(SparseMatrix(model.kkt().selfadjointView<Eigen::Lower>()));
  forEachUnknown(x, step, [&](Index k, const Eigen::VectorXd& up, const Eigen::VectorXd& down) {
    if (isGauge && isGauge(k))
    {
      return;
    }
    const Eigen::VectorXd bend = (slope(up) - slope(down)) / (2.0 * step);
    EXPECT_LT((kkt.col(k).head(x.size()) - bend).norm(), hessian * (1.0 + bend.norm())) << k;
    const Eigen::VectorXd row = (model.constraints(up) - model.constraints(down)) / (2.0 * step);
    EXPECT_LT((kkt.col(k).tail(row.size()) - row).norm(), jacobian * (1.0 + row.norm())) << k;
  });
}

/// Goes from x to a minimum by gradients alone, with the limited-memory BFGS method and halved
/// steps. \param function gives value and gradient
template <typename Function>
void minimizeByGradients(
  const Function& function, Eigen::VectorXd& x, int maxSteps, double smallestGradient)
{
  constexpr std::size_t memory = 50;
  std::deque<std::pair<Eigen::VectorXd, Eigen::VectorXd>> pairs; // steps and changes of gradients
  Eigen::VectorXd gradient;
  double value = function(x, gradient);
  for (int step = 0; step < maxSteps && gradient.norm() > smallestGradient; ++step)
  {
    Eigen::VectorXd direction = -gradient;
    std::vector<double> factors;
    for (const auto& [s, y] : pairs)
    {
      factors.push_back(s.dot(direction) / s.dot(y));
      direction -= factors.back() * y;
    }
    direction *= pairs.empty()
      ? 1e-2 / gradient.norm()
      : pairs.front().first.dot(pairs.front().second) / pairs.front().second.squaredNorm();
    for (std::size_t k = pairs.size(); k-- > 0;)
    {
      const auto& [s, y] = pairs[k];
      direction += (factors[k] - y.dot(direction) / s.dot(y)) * s;
    }
    const double slope = gradient.dot(direction);
    double scale = 1.0;
    Eigen::VectorXd next;
    double there = function(x + scale * direction, next);
    while (!(there <= value + 1e-4 * scale * slope) && scale > 1e-16)
    {
      scale *= 0.5;
      there = function(x + scale * direction, next);
    }
    if (scale <= 1e-16 || !(there < value))
    {
      break;
    }
    if ((next - gradient).dot(direction) > 0.0)
    {
      pairs.emplace_front(scale * direction, next - gradient);
      pairs.resize(std::min(pairs.size(), memory));
    }
    x += scale * direction;
    gradient = next;
    value = there;
  }
}
}
