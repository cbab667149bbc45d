// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Sparse/LinearSolver.h"

#include <Eigen/Core>
#include <optional>

namespace flattening
{
/// Share of the decrease which the slope promises that a step must bring (Armijo's rule).
inline constexpr double sufficientDecrease = 1e-4;
/// A step that has to be shorter than 2^-40 of Newton's is lost in rounding.
inline constexpr int maximumHalvings = 40;

inline double largest(const Eigen::VectorXd& v)
{
  return v.size() ? v.cwiseAbs().maxCoeff() : 0.0;
}

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
  virtual std::vector<double> bounds() const { return {}; }

  virtual double objective(const Eigen::VectorXd& x, const Execution& execution) const = 0;
  virtual Eigen::VectorXd constraints(const Eigen::VectorXd& x) const = 0;
  /// What rounding leaves of the sum of |c_i(x)|, at this value of the merit function.
  virtual double constraintRounding(const Eigen::VectorXd&, double) const { return 0.0; }
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
  virtual void stiffen(Index /*bounded*/, double /*stiffness*/) {}
  virtual const SparseMatrix& kkt() const = 0;
  /// J' times a vector, with the Jacobian of the last linearize() or differentiate().
  virtual Eigen::VectorXd transposedJacobianTimes(const Eigen::VectorXd& multipliers) const = 0;
};

/// The Newton step of a model from one point after the other: the KKT system there, with a Hessian
/// that is convex on the constraints' tangent space and bounded unknowns held where they leave
/// their bounds.
class NewtonKktStep
{
public:
  /// \param solver for the model's KKT matrix; it must tell the inertia.
  NewtonKktStep(NewtonKktModel& model, LinearSolver solver, const Execution& execution);

  /// Whether the run is cancelled; the caller is not asked again once it is.
  bool cancelled();

  /// Constraints are squared terms mu / 2 c^2 of the objective from now on, with mu c for their
  /// multipliers: [H, J'; J, -I / mu] is H + mu J'J.
  void setPenalty(double mu) { this->InversePenalty = 1.0 / mu; }
  /// Chord steps, by linearizeForChord(), will reduce what rounding leaves of the full steps.
  void enableChordSteps() { this->ChordSteps = true; }
  /// See NewtonKktOptions::amongSaddles.
  void enableSaddleHandling() { this->HandlesSaddles = true; }
  /// How many there were.
  int factorizations() const { return this->Factorizations; }
  /// Goes to a point.
  void linearize(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, Curvature curvature);
  /// Goes to a point whose step the last factorization is to give: Newton's with the matrix of an
  /// earlier point, which costs next to nothing and errs by as much as the matrix has changed.
  /// False, and nothing has changed, where there is none without a shift, or an unknown is held.
  bool linearizeForChord(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers);
  /// Whether the last factorization is that of the exact Hessian as it is, found convex on the
  /// constraints' tangent space.
  bool nearMinimum() const { return this->HasUnshiftedFactor && this->Hessian == Curvature::Exact; }
  const Eigen::VectorXd& gradient() const { return this->Point.gradient; }
  const Eigen::VectorXd& constraints() const { return this->Point.constraints; }
  Curvature curvature() const { return this->Hessian; }
  /// Largest entry of the gradient of the Lagrangian over the unknowns that are free to move.
  double optimality(const Eigen::VectorXd& multipliers) const;

  /// \param fraction of the last step that could be taken: where it is small, the next steps are
  /// shortened and turned by a shift of the Hessian, until whole ones can be taken again.
  void updateDamping(double fraction);
  /// Finds the step from there and its multipliers; false where there is none.
  bool solve();
  const Eigen::VectorXd& step() const { return this->Step; }
  const Eigen::VectorXd& multipliers() const { return this->Multipliers; }
  /// By how much the step would lower the objective.
  double predictedReduction() const;
  /// tau that was added to the Hessian.
  double shift() const { return this->Shift; }
  /// Whether the exact Hessian was found to bend downwards somewhere on the constraints' tangent
  /// space, so that no minimum is near.
  bool isIndefinite() const { return this->Indefinite; }
  /// The direction there in which it bends downwards most, its largest entry one; nothing where
  /// none is found.
  Eigen::VectorXd negativeCurvatureDirection();
  /// Whether the step's multipliers draw an unknown back that is held on its bound.
  bool shouldLeaveActiveSet() const;

  /// The point within the bounds next to one.
  Eigen::VectorXd clipped(Eigen::VectorXd x) const;
  /// Makes corrections from here shortest in the unknowns; before, they are those that cost least,
  /// and go so far where the Hessian is soft that they leave more than they take. Costs a
  /// factorization; false where that fails.
  bool shortenCorrections();
  /// Least change that takes back what the linear model left of the constraints at x.
  Eigen::VectorXd corrected(const Eigen::VectorXd& x) const;

private:
  Index unknownOf(std::size_t bounded) const
  {
    return this->FirstBounded + static_cast<Index>(bounded);
  }
  Eigen::VectorXd lagrangianGradient(const Eigen::VectorXd& multipliers) const;
  void findActiveSet();
  bool growActiveSet();
  bool tryFactorize();
  bool factorize();
  bool shiftUntilConvex(double tau, int most, double largest);
  bool solveActive();
  bool solveChord();
  bool splitSolution(const Eigen::VectorXd& solution);
  struct KktSolution
  {
    Eigen::VectorXd x; ///< empty where the factor gives none
    /// What the first solution left of the right-hand side, as a fraction, where it is refined, and
    /// at most what the refined one leaves.
    double firstResidual = 0.0;
    double refinedResidual = 0.0;
  };
  KktSolution solveKkt(const Eigen::VectorXd& rhs) const;

  NewtonKktModel& Model;
  LinearSolver Solver;
  const Execution& Run;
  std::vector<double> Bounds;
  Index Unknowns;
  Index Constraints;
  Index FirstBounded;
  std::vector<char> Active;   ///< bounded unknowns that are, or in this step go, to their bound
  Eigen::VectorXd ActiveStep; ///< how far those go
  Eigen::VectorXd X;          ///< the point
  Eigen::VectorXd OldMultipliers;
  NewtonKktModel::Linearization Point;
  Curvature Hessian = Curvature::Convex;
  double Shift = 0.0;          ///< tau in the KKT matrix
  double LastShift = 0.0;      ///< of the last factorization
  double InversePenalty = 0.0; ///< 1 / mu; 0: constraints hold
  double ExactShift = 0.0;     ///< of the last factorization with the exact Hessian
  double Damping = 0.0;        ///< least shift of the next
  Eigen::VectorXd Step;
  Eigen::VectorXd Multipliers;
  /// What the last factor leaves of a right-hand side without refinement, as a fraction.
  double FirstResidual = 0.0;
  int Factorizations = 0;
  bool HandlesSaddles = false;
  bool Indefinite = false;
  bool ChordSteps = false;
  bool HasUnshiftedFactor = false; ///< the matrix, without a shift
  bool Chord = false;              ///< the matrix is that of an earlier point
  bool Stopped = false;
};
}
