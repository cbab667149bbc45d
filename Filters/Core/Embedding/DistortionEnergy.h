// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleFrame.h"

namespace flattening
{
/// What deforming a triangle of the sheet costs, per area.
enum class DistortionEnergyKind
{
  /// |J - R|^2 with the rotation R nearest to J (Liu, Zhang, Xu, Gotsman, Gortler, "A local/global
  /// approach to mesh parameterization", 2008).
  AsRigidAsPossible,
  /// |J|^2 + |J^-1|^2 - 4, infinite where a triangle collapses (Smith and Schaefer, "Bijective
  /// parameterization with free boundaries", 2015).
  SymmetricDirichlet,
  /// Of an option: SymmetricDirichlet where a piece has a free boundary, else AsRigidAsPossible.
  Automatic,
};

struct DistortionEnergy
{
  DistortionEnergyKind kind = DistortionEnergyKind::AsRigidAsPossible;
  /// As rigid as possible only, in (-1, 1): with the stretches S >= s the energy is
  /// (1 + bias) (S + s - 2)^2 / 2 + (1 - bias) (S - s)^2 / 2. Above 0 a change of area costs more
  /// than a change of angle, as in a stiff sheet; below 0 less, as in a stretchy one; 0 is |J -
  /// R|^2.
  double bias = 0.0;
};

/// Energy density of a linear map, its gradient and Hessian.
///
/// The map x -> J x is given by its conformal and anticonformal parts, as complex numbers
/// q = (J11 + J22) + i (J21 - J12) and p = (J11 - J22) + i (J21 + J12), in the order
/// (Re q, Im q, Re p, Im p). Then S + s = |q| and S - s = |p|, with s < 0 where the map flips.
struct DistortionEnergyValue
{
  double value = 0.0;
  Eigen::Vector4d gradient;
  Eigen::Matrix4d hessian;
};

/// Derivative of a triangle's map parts (q, p) by the planar positions of its three corners.
Eigen::Matrix<double, 4, 6> mapPartsDerivative(const TriangleFrame& frame);

/// Those parts of the map that takes a triangle to placeOf(v) of each of its corners v.
template <class PlaceOf>
Eigen::Vector4d mapParts(const TriangleFrame& frame, const Triangle& t, const PlaceOf& placeOf)
{
  Eigen::Matrix<double, 6, 1> corners;
  corners << placeOf(t[0]), placeOf(t[1]), placeOf(t[2]);
  return mapPartsDerivative(frame) * corners;
}

/// Partial derivatives of a density that depends on |J|^2 and det J only.
struct NormDetDensity
{
  double value = 0.0;
  double byNorm = 0.0;
  double byDet = 0.0;
  double byNormDet = 0.0;
  double byDet2 = 0.0;
};

/// Such a density by the parts of the map; |J|^2 = (|q|^2 + |p|^2) / 2, det J = (|q|^2 - |p|^2)
/// / 4.
DistortionEnergyValue expandNormDet(
  const NormDetDensity& density, const Eigen::Vector4d& parts, bool convex);

/// \param convex replace the Hessian by the nearest positive semidefinite one.
DistortionEnergyValue evaluateDistortionEnergy(
  const DistortionEnergy& energy, const Eigen::Vector4d& parts, bool convex);

/// The gradient alone.
Eigen::Vector4d distortionEnergyGradient(
  const DistortionEnergy& energy, const Eigen::Vector4d& parts);

/// The density alone.
double distortionEnergyDensity(const DistortionEnergy& energy, const Eigen::Vector4d& parts);
}
