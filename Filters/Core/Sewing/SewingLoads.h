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

/// Pressure behind a sheet, along its normals: -pressure times the volume in front of which it
/// lies, (1/6) sum of det(a, b, c) over its triangles. That is a volume where the sheet is closed
/// or its boundary held.
class InnerPressure
{
public:
  InnerPressure(const SpaceUnknowns& unknowns, const SewnMembrane& sheet, double pressure);

  double energy(const Eigen::VectorXd& x) const;
  void declare(SpaceMatrix& matrix);
  /// Adds the gradient and, where it is the exact one, the Hessian at x: no part of it is convex.
  void add(const Eigen::VectorXd& x, Curvature curvature, SpaceMatrix& matrix,
    Eigen::VectorXd& gradient) const;

private:
  double volume(const Eigen::VectorXd& x) const;

  const SpaceUnknowns& Unknowns;
  const SewnMembrane& Sheet;
  double Pressure;
  double Offset = 0.0;                   ///< so that the energy is not below zero
  std::vector<SymmetricBlock<9>> Blocks; ///< of the triangles
};

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
