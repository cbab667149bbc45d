// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace flattening
{
/// What deforming a sheet in space costs per area of its flat rest, by the metric C = J^T J of the
/// map J from the plane into space, as (C11, C22, C12), with derivatives by these three.
struct MetricDensity
{
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

/// Young's modulus of the density below over its unit, for small strains and bias 0.
inline constexpr double isotropicModulus = 2.0;

/// The isotropic sheet of the flattening (DistortionEnergy, as rigid as possible) in space:
/// (1 + bias) (S + s - 2)^2 / 2 + (1 - bias) (S - s)^2 / 2 with the stretches S >= s >= 0, so that
/// a flat piece without distortion is the rest of its own design. Without bias it is convex in C.
MetricDensity evaluateIsotropicDensity(double bias, const Eigen::Vector3d& metric);
/// Its value alone.
double isotropicDensity(double bias, const Eigen::Vector3d& metric);
}
