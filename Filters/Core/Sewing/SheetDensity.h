// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/ClothEnergy.h"
#include "Cloth/ClothMaterial.h"

#include <Eigen/Core>
#include <optional>

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

/// What stretching a sheet in space costs per area of its flat rest, by the metric of the map from
/// the plane into space: the isotropic sheet, or a material with weft along x and warp along y,
///   k_v f(e_v) + k_u f(e_u) + k_uv e_u e_v + k_s g^2 / 2,
/// as ClothEnergy has it without limits, which are no stiffness: e_v and e_u are the strains of the
/// threads, f half their square, softer where they are compressed, and g = asin(C12 / sqrt(C11
/// C22)) the shear. The stiffer thread has the modulus of the isotropic sheet.
class SheetDensity
{
public:
  explicit SheetDensity(double areaBias);
  /// \param material that checkMaterial() lets pass, with threads.
  explicit SheetDensity(const ClothMaterial& material);

  double value(const Eigen::Vector3d& metric) const;
  MetricDensity evaluate(const Eigen::Vector3d& metric) const;
  /// Its Hessian by the metric has no negative eigenvalue anywhere.
  bool convexInMetric() const { return !this->Threads && !(this->Bias > 0.0); }

private:
  struct ThreadStiffness
  {
    double warp;
    double weft;
    double cross;
    double shear;
    double compression;
  };

  double threadValue(const ThreadStrain& strain) const;
  MetricDensity evaluateThreads(const Eigen::Vector3d& metric) const;

  double Bias = 0.0;
  std::optional<ThreadStiffness> Threads;
};

/// Of weft along x and warp along y; a triangle without area has no threads, and no strain.
ThreadStrain threadStrainOf(const Eigen::Vector3d& metric);
}
