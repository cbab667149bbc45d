// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/ClothMaterial.h"
#include "Cloth/ThreadEnergy.h"
#include "Embedding/DistortionEnergy.h"

#include <optional>

namespace flattening
{
/// What it costs a cloth to take the shape of the surface, per area of the surface:
///   det J (k_v f(e_v) + k_u f(e_u) + k_uv e_u e_v + k_s g^2 / 2 + limits),
/// with the strains e_v of the warp, e_u of the weft and the shear g of ThreadStrain, f(e) = e^2 /
/// 2 where a thread is drawn and the softer r e^2 / 2 where it is compressed, joined with two
/// derivatives, and limits the half squares of what strains and shear are beyond the material's
/// limits, of strains that are 5 % beyond in proportion from there on. The factor det J makes it an
/// energy of the cloth, which lies in the plane. It is without bound where a triangle collapses.
///
/// Stiffnesses are scaled so that the stiffer thread has 2: then a sheet with k_u = k_v = 2 k_s
/// costs |J - R|^2 to second order.
class ClothEnergy
{
public:
  /// \param material that checkMaterial() lets pass. \param limitStiffness of what is beyond a
  /// limit, over that of the stiffer thread; 0: limits do not count.
  ClothEnergy(const ClothMaterial& material, double limitStiffness);

  /// For the map with these parts (see DistortionEnergyValue), weft along x and warp along y.
  /// \param convex replace the Hessian by the nearest positive semidefinite one.
  DistortionEnergyValue evaluate(const Eigen::Vector4d& parts, bool convex) const;
  /// The same gradient alone, which takes a tenth of the time.
  Eigen::Vector4d gradient(const Eigen::Vector4d& parts) const;
  double density(const Eigen::Vector4d& parts) const;

  /// How hard an edge of the sheet is to bend inwards, over that of |J - R|^2: of an orthotropic
  /// half-plane with the threads along and across its edge, the mean of both ways (its surface
  /// compliance is in Lekhnitskii, "Anisotropic plates", 1968). Soft shear makes it soft.
  double edgeModulus() const;

private:
  struct Thread
  {
    double stiffness;
    double compression;
    StrainLimits limits;
  };

  struct Measures;

  double strainEnergy(const ThreadStrain& strain) const;
  /// No value where no cloth can have the map.
  std::optional<Measures> measure(const Eigen::Vector4d& parts) const;
  static Eigen::Matrix4d hessian(const Measures& m);

  Thread Warp;
  Thread Weft;
  double Cross;
  double Shear;
  double ShearLimit;
  double LimitStiffness;
};

/// Rows of J, one after the other, of a map given by its parts (q, p).
Eigen::Vector4d rowsOfMap(const Eigen::Vector4d& parts);
}
