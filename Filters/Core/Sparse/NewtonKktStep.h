// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/NewtonKktModel.h"

namespace flattening
{
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
  void setPenalty(double mu) { this->Softness = 1.0 / mu; }
  /// Chord steps, by follow(), will reduce what rounding leaves of the full steps.
  void enableChordSteps() { this->Followers = true; }
  /// See NewtonKktOptions::amongSaddles.
  void enableSaddleHandling() { this->Saddles = true; }
  /// How many there were.
  int factorizations() const { return this->Factorizations; }
  /// Goes to a point.
  void linearize(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, Curvature curvature);
  /// Goes to a point whose step the last factorization is to give: Newton's with the matrix of an
  /// earlier point, which costs next to nothing and errs by as much as the matrix has changed.
  /// False, and nothing has changed, where there is none without a shift, or an unknown is held.
  bool follow(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers);
  /// Whether the last factorization is that of the exact Hessian as it is, found convex on the
  /// constraints' tangent space.
  bool nearMinimum() const { return this->Factored && this->Taken == Curvature::Exact; }
  const Eigen::VectorXd& gradient() const { return this->Point.gradient; }
  const Eigen::VectorXd& constraints() const { return this->Point.constraints; }
  Curvature curvature() const { return this->Taken; }
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
  void holdAtBounds();
  bool holdLeaving();
  bool factorizes();
  bool factorize();
  bool shiftUntilConvex(double tau, int mostShifts, double largest);
  bool solveHeld();
  bool solveFollowing();
  bool takeSolution(const Eigen::VectorXd& solution);
  struct KktSolution
  {
    Eigen::VectorXd x; ///< empty where the factor gives none
    /// What the first solution left of the right-hand side, as a fraction, where it is refined.
    double leftByFactor = 0.0;
  };
  KktSolution solveKkt(const Eigen::VectorXd& rhs) const;

  NewtonKktModel& Model;
  LinearSolver Solver;
  const Execution& Run;
  std::vector<double> Bounds;
  Index Unknowns;
  Index Constraints;
  Index FirstBounded;
  std::vector<char> Held;   ///< bounded unknowns that are, or in this step go, to their bound
  Eigen::VectorXd HeldStep; ///< how far those go
  Eigen::VectorXd X;        ///< the point
  Eigen::VectorXd OldMultipliers;
  NewtonKktModel::Linearization Point;
  Curvature Taken = Curvature::Convex;
  double Shift = 0.0;      ///< tau in the KKT matrix
  double LastShift = 0.0;  ///< of the last factorization
  double Softness = 0.0;   ///< 1 / mu; 0: constraints hold
  double ExactShift = 0.0; ///< of the last factorization with the exact Hessian
  double Damping = 0.0;    ///< least shift of the next
  Eigen::VectorXd Step;
  Eigen::VectorXd Multipliers;
  /// What the last factor leaves of a right-hand side without refinement, as a fraction.
  double LeftByFactor = 0.0;
  int Factorizations = 0;
  bool Saddles = false;
  bool Indefinite = false;
  bool Followers = false;
  bool Factored = false;  ///< the matrix, without a shift
  bool Following = false; ///< the matrix is that of an earlier point
  bool ToldToStop = false;
};
}
