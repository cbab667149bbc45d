// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Sewing/SheetDensity.h"
#include "Sewing/SpaceMatrix.h"
#include "Sparse/NewtonKktStep.h"
#include "Surface/TriangleFrame.h"

namespace flattening
{
/// Where the free vertices of a sheet in space stand among the unknowns, the others being held.
struct SpaceUnknowns
{
  Points3 points; ///< per vertex; those of free ones are not used
  Indices first;  ///< per vertex the unknown of its x, those of y and z follow; none: it is held

  Point3 at(Index vertex, const Eigen::VectorXd& x) const
  {
    return this->first[vertex] == none ? this->points[vertex]
                                       : Point3(x.segment<3>(this->first[vertex]));
  }
  /// Adds a vertex's part of a vector of the unknowns, unless it is held.
  void scatter(Index vertex, const Point3& part, Eigen::VectorXd& whole) const
  {
    if (this->first[vertex] != none)
    {
      whole.segment<3>(this->first[vertex]) += part;
    }
  }
};

/// What stretching a sheet in space costs, which is flat at rest: the sum over its triangles of the
/// area at rest times the density of what it is made of.
class SewnMembrane
{
public:
  /// \param rest of each triangle, in a unit in which the mean area is 1.
  SewnMembrane(const SpaceUnknowns& unknowns, Triangles triangles, std::vector<TriangleFrame> rest,
    const SheetDensity& density);

  const Triangles& triangles() const { return this->Cells; }
  const std::vector<TriangleFrame>& rest() const { return this->Frames; }
  /// Per vertex a third of the triangles around it, at rest.
  std::vector<double> vertexAreas() const;

  double energy(const Eigen::VectorXd& x, const Execution& execution) const;
  void declare(SpaceMatrix& matrix) const;
  /// Adds gradient and Hessian at x. Convex: without the part of the stresses that compress, which
  /// is where a sheet buckles.
  void add(const Eigen::VectorXd& x, Curvature curvature, SpaceMatrix& matrix,
    Eigen::VectorXd& gradient, const Execution& execution) const;

private:
  Eigen::Matrix<double, 3, 2> mapOf(Index t, const Eigen::VectorXd& x) const;
  /// Of the energy of one triangle.
  struct Derivatives
  {
    Eigen::Matrix<double, 9, 1> gradient;
    /// Of corners (0, 0), (1, 0), (1, 1), (2, 0), (2, 1) and (2, 2).
    std::array<Eigen::Matrix3d, 6> hessian;
  };
  Derivatives derive(Index t, const Eigen::VectorXd& x, bool convex) const;
  void addOne(
    Index t, const Derivatives& derived, SpaceMatrix& matrix, Eigen::VectorXd& gradient) const;

  const SpaceUnknowns& Unknowns;
  Triangles Cells;
  std::vector<TriangleFrame> Frames;
  SheetDensity Density;
};

/// A triangle at rest in the plane, with the gradients of its frame along the axes of the plane,
/// which the threads of a material follow.
TriangleFrame restFrame(const std::array<Point2, 3>& corners);
/// Stretches S >= s >= 0 of a map from the plane into space, by its metric (C11, C22, C12).
std::array<double, 2> stretchesOf(const Eigen::Vector3d& metric);
/// The map of a triangle from its rest into space: the images of the rest's x and y.
Eigen::Matrix<double, 3, 2> mapIntoSpace(
  const TriangleFrame& rest, const Point3& a, const Point3& b, const Point3& c);
Eigen::Vector3d metricOf(const Eigen::Matrix<double, 3, 2>& map);
}
