// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/ClothEnergy.h"

#include <variant>
#include <vector>

namespace flattening
{
/// What deforming a triangle costs: of a sheet alike in all directions, or of a cloth.
class SheetEnergy
{
public:
  // NOLINTNEXTLINE(google-explicit-constructor): a distortion energy is a sheet's
  SheetEnergy(const DistortionEnergy& energy = {})
    : Energy(energy)
  {
  }
  // NOLINTNEXTLINE(google-explicit-constructor)
  SheetEnergy(const ClothEnergy& energy)
    : Energy(energy)
  {
  }

  /// Whether turning the plane changes nothing. Of a cloth the threads lie along its axes.
  bool turnsFreely() const { return this->plain() != nullptr; }
  /// Over that of |J - R|^2, for small strains, as wires at its edge feel it.
  double modulus() const
  {
    if (!this->plain())
    {
      return std::get<ClothEnergy>(this->Energy).edgeModulus();
    }
    return this->plain()->kind == DistortionEnergyKind::SymmetricDirichlet ? 4.0 : 1.0;
  }
  double density(const Eigen::Vector4d& parts) const
  {
    return this->plain() ? distortionEnergyDensity(*this->plain(), parts)
                         : std::get<ClothEnergy>(this->Energy).density(parts);
  }
  DistortionEnergyValue evaluate(const Eigen::Vector4d& parts, bool convex) const
  {
    return this->plain() ? evaluateDistortionEnergy(*this->plain(), parts, convex)
                         : std::get<ClothEnergy>(this->Energy).evaluate(parts, convex);
  }
  Eigen::Vector4d gradient(const Eigen::Vector4d& parts) const
  {
    return this->plain() ? distortionEnergyGradient(*this->plain(), parts)
                         : std::get<ClothEnergy>(this->Energy).gradient(parts);
  }

private:
  const DistortionEnergy* plain() const { return std::get_if<DistortionEnergy>(&this->Energy); }

  std::variant<DistortionEnergy, ClothEnergy> Energy;
};

/// Keeps a piece from turning on its cloth: a sum of weight . position over its vertices is zero.
/// The weights themselves have no sum, so that moving the piece changes nothing.
struct GrainHold
{
  struct Weight
  {
    Index vertex;
    Point2 weight; ///< of about 1 in all
  };
  std::vector<Weight> weights; ///< none: it may turn

  bool holds() const { return !this->weights.empty(); }
};
}
