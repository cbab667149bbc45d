// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"
#include "Sparse/NewtonKktStep.h"

#include <Eigen/Core>
#include <functional>
#include <limits>

namespace flattening
{
/// How an iteration ended.
enum class Termination
{
  Converged,
  IterationLimit, ///< it ran out of iterations, and was still getting on
  Stalled,        ///< no step gets nearer to the solution, or none has for long
  Cancelled,
};

/// Where the iteration starts, goes on and ends.
struct NewtonKktState
{
  Eigen::VectorXd x;
  Eigen::VectorXd multipliers; ///< of the constraints; empty: zero
  Termination termination = Termination::IterationLimit;
  int factorizations = 0; ///< that the way there took

  bool converged() const { return this->termination == Termination::Converged; }
  bool cancelled() const { return this->termination == Termination::Cancelled; }
};

/// One iteration, at the point where it starts.
struct NewtonKktRecord
{
  int iteration = 0;
  double objective = 0.0;
  double violation = 0.0;   ///< largest |c_i|
  double optimality = 0.0;  ///< largest entry of the gradient of the Lagrangian, of what is free
  double largestMove = 0.0; ///< of an unknown, in the step that led here
  double meanMove = 0.0;    ///< root of the mean square of the same
  bool exact = false;       ///< the exact Hessian, or its convex part
};

struct NewtonKktOptions
{
  // Termination.
  int maximumIterations = 100;
  /// No iteration starts after this many factorizations, which take most of the time.
  int maximumFactorizations = std::numeric_limits<int>::max();
  /// Converged where every |c_i| is below the first and every entry of the gradient of the
  /// Lagrangian, over the model's scale, below the second, ...
  double constraintTolerance = 1e-10;
  double optimalityTolerance = 1e-10;
  /// ... or the predicted reduction of the objective is at most this fraction of it, ...
  double reductionTolerance = 0.0;
  /// ... or a full step of an unshifted Hessian moved every unknown by at most this. Constraints
  /// then need the second tolerance only. Below zero: never.
  double stepTolerance = -1.0;
  double stepConstraintTolerance = 0.0;

  // The model switches to its final objective where the predicted reduction is at most this
  // fraction of the objective and every |c_i| at most the second; at the latest in this iteration,
  // or where no step is found.
  double finalObjectiveReduction = 0.0;
  double finalObjectiveConstraint = 0.0;
  int finalObjectiveIteration = std::numeric_limits<int>::max();

  // Modification of the Hessian.
  /// The exact Hessian is used where the step before moved every unknown by less; far from a
  /// minimum it is seldom convex. The first step counts as infinite.
  double exactWithin = std::numeric_limits<double>::infinity();
  /// The same before the switch to the final objective, if it is less.
  double exactBeforeSettling = std::numeric_limits<double>::infinity();
  /// Shifts the exact Hessian before its convex part is used, and shifts the next steps after short
  /// ones: for wires under pressure, which have many saddles.
  bool amongSaddles = false;
  /// Where the Hessian is indefinite and the predicted reduction at most this fraction of the
  /// objective (constraints as above), the point is left along the direction of most negative
  /// curvature, which takes several factorizations.
  double saddleReduction = 0.0;

  // Line search on the merit function.
  /// Weight of a constraint over its multiplier. Above 1 the function is exact; the margin keeps it
  /// exact while multipliers change, and shortens steps.
  double penaltyMargin = 1.5;
  /// Least weight of a constraint over the largest one: 1 weighs all equally, less does not hold
  /// constraints of one kind by the multipliers of another.
  double penaltyShare = 1.0;
  /// Steps are shortened to this largest move of an unknown: equations in angles repeat themselves,
  /// and longer steps lead to another branch.
  double maximumMove = std::numeric_limits<double>::infinity();
  /// Number of halvings tried with second-order correction as well. Each costs a solution.
  int corrections = 1;
  /// Repeats a correction while it helps, and where the cheapest corrections fail takes the
  /// shortest ones, at the cost of a factorization.
  bool correctsAgain = false;

  /// A factorization serves the next points (chord steps) while full steps reduce the residual of
  /// the optimality conditions to this fraction at most. 0: each point has its own.
  double chordReduction = 0.0;

  /// Name in reports of progress; null: none are made.
  const char* phase = nullptr;
  std::function<void(const NewtonKktRecord&)> observe;
};

/// Newton's method for a minimum under constraints and bounds, as sequential quadratic programming
/// (Nocedal and Wright, Numerical Optimization, chapter 18): KKT systems by LDL^T with a small
/// -delta I block and refinement, a Hessian that is convex on the constraints' tangent space by the
/// inertia of D (its convex part, or a shift tau I, where it is not), steps by an L1 merit function
/// with second-order correction, bounds by an active set.
/// \param solver for the model's KKT matrix; it must tell the inertia.
NewtonKktState minimize(NewtonKktModel& model, NewtonKktState start, LinearSolver solver,
  const NewtonKktOptions& options, const Execution& execution);
}
