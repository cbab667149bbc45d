// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sewing/SewnMembrane.h"

namespace flattening
{
/// The weight of a sheet: minus force times displacement from the design, a third of each
/// triangle's area at rest to each of its corners.
class ClothWeight
{
public:
  /// \param force per area at rest, in the unit of the membrane's energy over its unit of length.
  ClothWeight(const SpaceUnknowns& unknowns, const SewnMembrane& sheet, const Point3& force);

  double energy(const Eigen::VectorXd& x) const;
  void add(Eigen::VectorXd& gradient) const;

private:
  const SpaceUnknowns& Unknowns;
  Point3 Force;
  std::vector<double> Area; ///< per vertex
  double Offset = 0.0;      ///< so that the energy is not below zero
};
}
