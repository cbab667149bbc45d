// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"
#include "Sparse/NewtonKktModel.h"

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

namespace flattening
{
/// How an iteration ended.
enum class Ending
{
  Converged,
  Exhausted, ///< it ran out of iterations, and was still getting on
  Stalled,   ///< no step gets nearer to the solution, or none has for long
  Cancelled,
};

/// Whether an iteration has got no nearer to zero in the second half of its run than in the first.
/// \param residuals of at least 40 iterations; of fewer nothing is known
inline bool standsStill(const std::vector<double>& residuals)
{
  constexpr std::size_t fewest = 40;
  constexpr double noticeable = 0.9;
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  return residuals.size() >= fewest &&
    *std::min_element(middle, residuals.end()) >=
    noticeable * *std::min_element(residuals.begin(), middle);
}

/// Share of the decrease which the slope promises that a step must bring (Armijo's rule).
constexpr double sufficientDecrease = 1e-4;

inline double largest(const Eigen::VectorXd& v)
{
  return v.size() ? v.cwiseAbs().maxCoeff() : 0.0;
}

/// Objective plus the sum of penalty_i |c_i|, which a step of sequential quadratic programming
/// lowers: exact where each penalty is above its constraint's multiplier.
class MeritFunction
{
public:
  /// \param margin of a penalty over its multiplier; it keeps the function exact while multipliers
  /// change, and shortens steps. \param share least penalty over the largest.
  MeritFunction(Index constraints, double margin, double share)
    : Penalties(Eigen::VectorXd::Zero(constraints))
    , Margin(margin)
    , Share(share)
  {
  }

  /// Penalties only grow, so that steps get on by one measure.
  void raise(const Eigen::VectorXd& multipliers)
  {
    const Eigen::VectorXd asked = this->Margin * multipliers.cwiseAbs();
    const double least = this->Share * (asked.size() ? asked.maxCoeff() : 0.0);
    this->Penalties =
      this->Penalties.cwiseMax((asked.array().max(least) + smallestPenalty).matrix());
  }
  void forget() { this->Penalties.setZero(); }

  double violation(const Eigen::VectorXd& constraints) const
  {
    return constraints.cwiseAbs().dot(this->Penalties);
  }
  double largestPenalty() const
  {
    return this->Penalties.size() ? this->Penalties.maxCoeff() : 0.0;
  }

private:
  /// Where no multiplier asks for one.
  static constexpr double smallestPenalty = 1e-3;

  Eigen::VectorXd Penalties;
  double Margin;
  double Share;
};

/// Where the iteration starts, goes on and ends.
struct NewtonKktState
{
  Eigen::VectorXd x;
  Eigen::VectorXd multipliers; ///< of the constraints; empty: zero
  Ending ending = Ending::Exhausted;
  int factorizations = 0; ///< that the way there took

  bool converged() const { return this->ending == Ending::Converged; }
  bool cancelled() const { return this->ending == Ending::Cancelled; }
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
  int maximumIterations = 100;
  /// Nor is another iteration begun after so many factorizations, which is what takes the time.
  int mostFactorizations = std::numeric_limits<int>::max();
  /// The iteration ends where no |c_i| is as large and the point is stationary: no entry of the
  /// gradient of the Lagrangian, over the model's scale, is as large as the optimality tolerance,
  /// ...
  double constraintTolerance = 1e-10;
  double optimalityTolerance = 1e-10;
  /// ... or a further step promises to lower the objective by no more than this fraction of it, ...
  double promiseTolerance = 0.0;
  /// ... or a whole step, that of an unshifted Hessian, moved no unknown by more than this. Then
  /// constraints need only hold to the second tolerance. Less than zero: never.
  double stillMove = -1.0;
  double stillConstraintTolerance = 0.0;
  /// The model is told to settle where a further step promises to lower the objective by no more
  /// than this fraction of it and no |c_i| is larger than the second; at the latest after so many
  /// iterations, or where no step is found.
  double settlePromise = 0.0;
  double settleConstraint = 0.0;
  int settleBy = std::numeric_limits<int>::max();
  /// Where the Hessian bends downwards and a further step promises no more than this fraction of
  /// the objective, constraints as above, the point counts as a saddle: it is left along the
  /// direction that bends downwards most, which takes several factorizations.
  double saddlePromise = 0.0;
  /// Correct a step again where that helps, and where corrections that cost least leave more of the
  /// constraints than they take, take those that are shortest, at the price of a factorization.
  bool correctsAgain = false;
  /// Longer steps are shortened to one that moves no unknown by more: where the model's equations
  /// repeat themselves, as those of angles do, longer ones lead to another branch.
  double longestMove = std::numeric_limits<double>::infinity();
  /// The exact Hessian is tried where the step before was shorter; far from a minimum it is seldom
  /// convex. The first step counts as infinite.
  double exactWithin = std::numeric_limits<double>::infinity();
  /// The same before the model has settled, if that is less.
  double exactBeforeSettling = std::numeric_limits<double>::infinity();
  /// Weight of a constraint in the merit function over its multiplier. Above 1 it is exact; the
  /// margin keeps it so while multipliers change, and shortens steps.
  double penaltyMargin = 1.5;
  /// Least weight of a constraint over the largest one's: 1 gives all the same, less does not hold
  /// constraints of one kind by the multipliers of another.
  double penaltyShare = 1.0;
  /// How many of the step's halvings are tried with second-order correction as well. Each costs a
  /// solution; where constraints bend much, one that is left out costs a factorization.
  int corrections = 1;
  /// A factorization serves the next points as well while whole steps by it bring the residual of
  /// the conditions of a minimum down to this fraction at least. 0: every point has its own.
  double followed = 0.0;
  /// Where what is pressed gives way to many sides: the exact Hessian is shifted before it is given
  /// up for its convex part, and steps that had to be short shift the next ones.
  bool amongSaddles = false;
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
