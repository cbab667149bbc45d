// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Isometric/SheetEnergy.h"
#include "Sparse/NewtonKktModel.h"
#include "Sparse/SparseBlocks.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// The sheet's part of IsometricModel: the energy of every triangle of a piece, by the coordinates
/// x and y of vertex v as unknowns 2 v and 2 v + 1, in a unit in which the mean triangle area is 1.
class IsometricSheet
{
public:
  /// \param unit of length.
  IsometricSheet(const TriangleMesh& mesh, double unit, const SheetEnergy& energy);

  const Triangles& triangles() const { return this->Cells; }
  /// Modulus over that of |J - R|^2, for small strains.
  double modulus() const { return this->Energy.modulus(); }
  bool turnsFreely() const { return this->Energy.turnsFreely(); }

  /// Sum of the triangles' areas times their energy densities.
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

  Triangles Cells;
  SheetEnergy Energy;
  std::vector<TriangleFrame> Frames; ///< in units
  Index FirstEntry = none;           ///< of the first triangle; those of the others follow
};
}
