// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Cloth/ClothEnergy.h"
#include "Sparse/NewtonKktStep.h"
#include "Sparse/SymmetricAssembler.h"
#include "Surface/RegionWeights.h"
#include "Surface/TriangleMesh.h"

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

/// Triangles of the plane between parts of a piece's boundary, which are deformed with the piece.
/// While none of them turns over, the boundary does not cross what they fill.
struct BoundaryFilling
{
  Triangles triangles; ///< of the piece's vertices
  Points2 rest;        ///< where the vertices lie when the triangles have no strain
  /// Shapes without strain of the piece's own triangles, as sides from their first corners. Empty:
  /// those on the surface.
  std::vector<std::array<Point2, 2>> shapes;

  /// What one costs is that of this share of a triangle of mean area: it holds nothing back that
  /// matters, but the barrier of the energy is the same.
  static constexpr double share = 1e-3;
};

/// The sheet's part of IsometricModel: the energy of every triangle of a piece, by the coordinates
/// x and y of vertex v as unknowns 2 v and 2 v + 1, in a unit in which the mean triangle area is 1.
class IsometricSheet
{
public:
  /// \param unit of length. \param weights of the mesh's triangles; empty: 1
  IsometricSheet(const TriangleMesh& mesh, double unit, const SheetEnergy& energy,
    const BoundaryFilling& filling, const RegionWeights& weights);

  /// Modulus over that of |J - R|^2, for small strains.
  double modulus() const { return this->Energy.modulus(); }
  bool turnsFreely() const { return this->Energy.turnsFreely(); }

  /// Sum of the triangles' weights times their areas and energy densities.
  double energy(const Eigen::VectorXd& x, const Execution& execution) const;

  /// How many entries declare() declares.
  std::size_t entryCount() const { return Block::entryCount * this->Cells.size(); }
  void declare(SymmetricAssembler& assembler);
  /// Adds gradient and Hessian at x.
  void add(const Eigen::VectorXd& x, Curvature curvature, SymmetricAssembler& assembler,
    Eigen::VectorXd& gradient, const Execution& execution) const;
  /// Adds the gradient alone.
  void addGradient(
    const Eigen::VectorXd& x, Eigen::VectorXd& gradient, const Execution& execution) const;

private:
  using Block = PointsBlock<3>;

  struct Derivatives
  {
    std::array<double, 21> hessian; ///< its lower triangle, row by row
    Eigen::Matrix<double, 6, 1> gradient;
  };

  Eigen::Vector4d mapParts(Index t, const Eigen::VectorXd& x) const;
  Derivatives derivatives(Index t, const Eigen::VectorXd& x, bool convex) const;

  Triangles Cells; ///< those of the filling last
  SheetEnergy Energy;
  TriangleFrames Frames;   ///< in units, areas with their weights
  Index FirstEntry = none; ///< of the first triangle; those of the others follow
};
}
