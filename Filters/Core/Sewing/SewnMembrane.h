// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Sewing/SheetDensity.h"
#include "Sparse/NewtonKktStep.h"
#include "Sparse/SymmetricAssembler.h"
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
  /// The unknowns of some vertices, x, y and z of each in turn; none of those that are held.
  template <std::size_t N>
  std::array<Index, 3 * N> of(const std::array<Index, N>& vertices) const
  {
    std::array<Index, 3 * N> all{};
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      const Index x = this->first[vertices[k / 3]];
      all[k] = x == none ? none : x + static_cast<Index>(k % 3);
    }
    return all;
  }
};

/// The lower triangle of the Hessian of a sheet in space, in which the unknowns of each vertex are
/// coupled.
class SpaceMatrix : public SymmetricAssembler
{
public:
  /// \param size how many unknowns.
  explicit SpaceMatrix(Index size)
    : SymmetricAssembler(size)
  {
    for (Index x = 0; x < size; x += 3)
    {
      this->Own.emplace_back(*this, std::array<Index, 3>{ x, x + 1, x + 2 });
    }
  }
  /// Adds a symmetric block of the vertex whose x is this unknown; none where it is held.
  void addOwn(Index x, const Eigen::Matrix3d& block)
  {
    if (x != none)
    {
      this->Own[x / 3].add(*this, block);
    }
  }

private:
  std::vector<SymmetricBlock<3>> Own;
};

/// What stretching a sheet in space costs, which is flat at rest: the sum over its triangles of the
/// area at rest times the density of what it is made of.
class SewnMembrane
{
public:
  /// \param rest of each triangle, in a unit in which the mean area is 1.
  SewnMembrane(const SpaceUnknowns& unknowns, Triangles triangles, TriangleFrames rest,
    const SheetDensity& density);

  const Triangles& triangles() const { return this->Cells; }
  const TriangleFrames& rest() const { return this->Frames; }
  /// Per vertex a third of the triangles around it, at rest.
  std::vector<double> vertexAreas() const;

  double energy(const Eigen::VectorXd& x, const Execution& execution) const;
  void declare(SpaceMatrix& matrix);
  /// Adds gradient and Hessian at x. Convex: without the part of the stresses that compress, which
  /// is where a sheet buckles.
  void add(const Eigen::VectorXd& x, Curvature curvature, SpaceMatrix& matrix,
    Eigen::VectorXd& gradient, const Execution& execution) const;

private:
  Eigen::Matrix<double, 3, 2> mapOf(Index t, const Eigen::VectorXd& x) const;
  /// Of the energy of one triangle.
  struct Derivatives
  {
    Eigen::Matrix<double, 9, 1> gradient = Eigen::Matrix<double, 9, 1>::Zero();
    Eigen::Matrix<double, 9, 9> hessian = Eigen::Matrix<double, 9, 9>::Zero(); ///< lower blocks
  };
  Derivatives derive(Index t, const Eigen::VectorXd& x, bool convex) const;

  const SpaceUnknowns& Unknowns;
  Triangles Cells;
  TriangleFrames Frames;
  SheetDensity Density;
  std::vector<SymmetricBlock<9>> Blocks; ///< of the triangles
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

/// What bending a sheet costs that is flat at rest, by the squared jumps of its slope across its
/// edges: 1/2 stiffness sum_e |sum_k K_k x_k|^2 / A_e over the edges between two triangles, with
/// K_k = 2 A grad(phi_k) . grad(phi_opposite) of both triangles and A_e the sum of their areas (M.
/// Bergou, M. Wardetzky, D. Harmon, D. Zorin, E. Grinspun, "A quadratic bending model for
/// inextensible surfaces", 2006). |sum K_k x_k| is 2 l sin(angle / 2) for an edge of length l. A
/// third of the weight there, which is three times the energy of a cylinder on a regular grid,
/// where every third edge takes all of its bending; here it is that of the cylinder. Isometric
/// motions change no weight, so the Hessian is constant.
class SheetBending
{
public:
  /// \param sheet its triangles and their rest. Two triangles at an edge bend it, whether they were
  /// sewn together there or hang together: a seam is as stiff as the cloth.
  /// \param twins per half-edge the other one of its edge in the sewn sheet, or none.
  SheetBending(const SpaceUnknowns& unknowns, const SewnMembrane& sheet, const Indices& twins,
    double stiffness);

  double energy(const Eigen::VectorXd& x) const;
  void declare(SpaceMatrix& matrix);
  /// Adds gradient and Hessian at x.
  void add(const Eigen::VectorXd& x, SpaceMatrix& matrix, Eigen::VectorXd& gradient) const;
  /// Vertices that it couples, for an order of elimination.
  void addCliques(Triangles& cliques) const;

private:
  struct Hinge
  {
    std::array<Index, 4> vertices; ///< ends of the edge, then the corners opposite to it
    Eigen::Vector4d weights;
    double stiffness;
    std::array<SymmetricBlock<4>, 3> blocks; ///< of x, y and z
  };
  Point3 bend(const Hinge& hinge, const Eigen::VectorXd& x) const;

  const SpaceUnknowns& Unknowns;
  std::vector<Hinge> Hinges;
};
}
