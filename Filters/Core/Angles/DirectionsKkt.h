// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/DirectionsForm.h"
#include "Sparse/SymmetricAssembler.h"

namespace flattening
{
/// The KKT matrix of the directions form, [H, J'; J, -delta I] (lower triangle), filled again and
/// again in one pattern: H the Hessian of objective + multipliers . closure, J the Jacobian of the
/// closure. Rows of J come after all unknowns.
class DirectionsKkt
{
public:
  /// Only refers to the form.
  explicit DirectionsKkt(const DirectionsForm& form);

  /// \param units of form.unitVectors(x)
  /// \param held per stretch group whether it stays: its row and column become those of the
  /// identity.
  void fill(const Eigen::VectorXd& x, const Points2& units, const Eigen::VectorXd& multipliers,
    const std::vector<char>& held, double delta);
  /// Adds to the diagonal of H, after fill(), but for what is held.
  void shift(double tau);
  const Eigen::SparseMatrix<double>& matrix() const { return this->Assembler.matrix(); }
  /// J' times a vector, at any x.
  Eigen::VectorXd transposedJacobianTimes(
    const Eigen::VectorXd& x, const Points2& units, const Eigen::VectorXd& vector) const;

private:
  /// Unknowns and numbers that a side brings.
  struct Side
  {
    Index in; ///< unknown rotation of the edge before the node; none where it is fixed
    Index out;
    Index group; ///< unknown stretch of the edge
    Index row;   ///< of the first closure of its loop
    double weight;
    double length; ///< in units, negative where the side runs back along its edge
    Index edge;
  };

  void declare(const Side& side);

  const DirectionsForm& Form;
  Index Unknowns;
  std::vector<Side> Sides;
  SymmetricAssembler Assembler;
  Index GroupEntries = 0;
  Index DiagonalEntries = 0;
  std::vector<char> Held; ///< per unknown
};
}
