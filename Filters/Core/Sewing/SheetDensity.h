// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/ClothMaterial.h"
#include "Cloth/ThreadStrain.h"
#include "Sewing/MetricDensity.h"

#include <optional>

namespace flattening
{
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
