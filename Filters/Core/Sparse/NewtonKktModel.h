// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Sparse/LinearSolver.h"

#include <Eigen/Core>

#include <optional>

namespace flattening
{
/// How the Hessian of a Lagrangian is taken.
enum class Curvature
{
  Exact,  ///< all terms
  Convex, ///< only what bends upwards, where the model knows such a part
};

/// What the Newton iteration solves: least objective f(x) under equations c(x) = 0, the last of the
/// unknowns (the stretches of elastic wires) within bounds.
class NewtonKktModel
{
public:
  virtual ~NewtonKktModel() = default;

  virtual Index unknownCount() const = 0;
  virtual Index constraintCount() const = 0;
  /// Of the last unknowns: each lies between minus its bound and its bound.
  virtual std::vector<double> bounds() const = 0;

  virtual double objective(const Eigen::VectorXd& x, const Execution& execution) const = 0;
  virtual Eigen::VectorXd constraints(const Eigen::VectorXd& x) const = 0;
  /// What rounding leaves of the sum of |c_i(x)|, at this value of the merit function.
  virtual double constraintRounding(const Eigen::VectorXd& x, double merit) const = 0;
  /// What an entry of the gradient of the Lagrangian is small against, at this objective.
  virtual double gradientScale(double) const { return 1.0; }
  /// What the rounding of the unknowns leaves of an entry of that gradient: none is asked to be
  /// smaller.
  virtual double gradientRounding(const Eigen::VectorXd&) const { return 0.0; }
  /// Told once, near a minimum, the multipliers there: the model may take on the objective that it
  /// is to end with. \return whether it is another one
  virtual bool switchToFinalObjective(const Eigen::VectorXd&) { return false; }

  struct Linearization
  {
    Eigen::VectorXd gradient; ///< of the objective
    Eigen::VectorXd constraints;
  };
  /// Gradient and constraints at x; fills the KKT matrix [H, J'; J, -delta I] (lower triangle), H
  /// the Hessian of objective + multipliers . constraints and J the Jacobian of the constraints,
  /// whose rows come after all unknowns.
  virtual Linearization linearize(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers,
    Curvature curvature, double delta, const Execution& execution) = 0;
  /// The same without the KKT matrix, which keeps what it holds; nothing where a model always wants
  /// both.
  virtual std::optional<Linearization> differentiate(const Eigen::VectorXd&, const Execution&)
  {
    return std::nullopt;
  }
  /// Whether Curvature::Convex is another Hessian than the exact one.
  virtual bool hasConvexPart() const { return false; }
  /// Adds to the diagonal of H, after linearize().
  virtual void shift(double tau) = 0;
  /// Adds to the diagonal at a bounded unknown, after linearize().
  virtual void stiffen(Index bounded, double stiffness) = 0;
  virtual const SparseMatrix& kkt() const = 0;
  /// J' times a vector, with the Jacobian of the last linearize() or differentiate().
  virtual Eigen::VectorXd transposedJacobianTimes(const Eigen::VectorXd& multipliers) const = 0;
};
}
