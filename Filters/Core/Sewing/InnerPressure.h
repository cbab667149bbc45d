// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sewing/SewnMembrane.h"

namespace flattening
{
/// Pressure behind a sheet, along its normals: -pressure times the volume in front of which it
/// lies, (1/6) sum of det(a, b, c) over its triangles. That is a volume where the sheet is closed
/// or its boundary held.
class InnerPressure
{
public:
  InnerPressure(const SpaceUnknowns& unknowns, const SewnMembrane& sheet, double pressure);

  double energy(const Eigen::VectorXd& x) const;
  /// Adds the gradient and, where it is the exact one, the Hessian at x: no part of it is convex.
  /// \param matrix coupled as the sheet's own.
  void add(const Eigen::VectorXd& x, Curvature curvature, SpaceMatrix& matrix,
    Eigen::VectorXd& gradient) const;

private:
  double volume(const Eigen::VectorXd& x) const;

  const SpaceUnknowns& Unknowns;
  const SewnMembrane& Sheet;
  double Pressure;
  double Offset = 0.0; ///< so that the energy is not below zero
};
}
