// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sewing/SewnMembrane.h"

namespace flattening
{
/// Springs that draw each vertex back to where the design has it: stiffness times the mean over the
/// area at rest of |x - design|^2. To shift all by a share of the root of the area costs stiffness
/// times what straining all by that share in one direction costs. With a bias b the square of how
/// far a vertex lies inwards costs 1 / (1 - b) times as much; at 1 it is all but forbidden.
class DesignAnchor
{
public:
  /// \param sheet its triangles and their rest, in a unit in which the mean area is 1.
  /// \param outwards per vertex, of length 1; not used without a bias.
  DesignAnchor(const SpaceUnknowns& unknowns, const SewnMembrane& sheet, double stiffness,
    double outsideBias, const Points3& outwards);

  double energy(const Eigen::VectorXd& x) const;
  /// Adds gradient and Hessian at x.
  void add(const Eigen::VectorXd& x, SpaceMatrix& matrix, Eigen::VectorXd& gradient) const;

private:
  struct Spring
  {
    Index first; ///< unknown of x; those of y and z follow
    Point3 design;
    Point3 outwards; ///< 0 without a bias
    double stiffness;
    double againstInwards; ///< beside that
  };
  /// How far it lies inwards, below 0, else 0.
  static double inwards(const Spring& spring, const Point3& moved);

  std::vector<Spring> Springs;
};
}
