// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/DirectionsForm.h"
#include "Sparse/NewtonKkt.h"
#include "Sparse/SymmetricAssembler.h"

namespace flattening
{
/// The directions form as Newton's method wants it. The stretches are the bounded unknowns.
class DirectionsKkt : public NewtonKktModel
{
public:
  /// Only refers to the form.
  explicit DirectionsKkt(const DirectionsForm& form);

  Index unknownCount() const override { return this->Form.unknownCount(); }
  Index constraintCount() const override { return this->Form.constraintCount(); }
  std::vector<double> bounds() const override;
  double objective(const Eigen::VectorXd& x, const Execution& execution = {}) const override;
  Eigen::VectorXd constraints(const Eigen::VectorXd& x) const override;
  double constraintRounding(const Eigen::VectorXd& x, double merit) const override;
  Linearization linearize(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers,
    Curvature curvature, double delta, const Execution& execution = {}) override;
  void shift(double tau) override;
  void stiffen(Index bounded, double stiffness) override;
  const SparseMatrix& kkt() const override { return this->Assembler.matrix(); }
  Eigen::VectorXd transposedJacobianTimes(const Eigen::VectorXd& multipliers) const override;

private:
  /// Numbers and entries that a side brings.
  struct Side
  {
    Index edge;
    Index row; ///< of the first closure of its loop, counted from 0
    double weight;
    double length;              ///< in units, negative where the side runs back along its edge
    SymmetricBlock<2> angle;    ///< of the rotations of the edges before and after the node
    SymmetricBlock<2> bend;     ///< of rotation and stretch of the edge
    JacobianBlock<2, 2> closes; ///< derivative of the loop's closures by these two
  };
  /// Derivative of closures by rotation and stretch, with the Jacobian of the last linearize().
  Eigen::Matrix2d closureDerivative(const Side& side) const;

  const DirectionsForm& Form;
  std::vector<Side> Sides;
  SymmetricAssembler Assembler;
  DiagonalBlock Diagonal;
  Points2 Units;              ///< directions of the wire edges at the last linearize()
  std::vector<double> Factor; ///< 1 + stretch per wire edge there
};
}
