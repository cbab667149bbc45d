// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/NewtonKkt.h"

#include "Sparse/MeritFunction.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// delta of the constraint block: it gives redundant constraints a pivot, and is small enough for
/// refinement to take it out again.
constexpr double regularization = 1e-8;
/// Each gains about eight digits, 1 / delta.
constexpr int refinements = 2;
/// Shifts tau of the Hessian: the smallest that matters beside entries about 1, growth by what
/// costs few factorizations and overshoots little, and a largest beside which the Hessian is
/// nothing.
constexpr double smallestShift = 1e-4;
constexpr double shiftGrowth = 4.0;
constexpr double largestShift = 1e12;
/// Share of the decrease which the slope promises that a step must bring (Armijo's rule).
constexpr double sufficientDecrease = 1e-4;
/// A step that has to be shorter than 2^-40 of Newton's is lost in rounding.
constexpr int mostHalvings = 40;
/// Rounding of the objective, a sum of some thousands of terms, as a fraction of it.
constexpr double objectiveRounding = 1e-13;
/// Holds a bounded unknown on its way: what multipliers do to it, divided by this, is below the
/// rounding of its bound.
constexpr double holdingStiffness = 1e20;

double largest(const Eigen::VectorXd& v)
{
  return v.size() ? v.cwiseAbs().maxCoeff() : 0.0;
}

class Iteration
{
public:
  Iteration(NewtonKktModel& model, NewtonKktState start, LinearSolver solver,
    const NewtonKktOptions& options, const Execution& execution)
    : Model(model)
    , State(std::move(start))
    , Solver(std::move(solver))
    , Options(options)
    , Run(execution)
    , Bounds(model.bounds())
    , Unknowns(model.unknownCount())
    , Constraints(model.constraintCount())
    , FirstBounded(Unknowns - static_cast<Index>(Bounds.size()))
    , Held(Bounds.size(), 0)
    , HeldStep(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(Bounds.size())))
    , Merit(Constraints, options.penaltyMargin, options.penaltyShare)
  {
    if (this->State.multipliers.size() != this->Constraints)
    {
      this->State.multipliers = Eigen::VectorXd::Zero(this->Constraints);
    }
  }

  NewtonKktState run()
  {
    this->Objective = this->Model.objective(this->State.x, this->Run);
    Ending ending = Ending::Cancelled;
    std::vector<double> residuals;
    for (int iteration = 0; !this->cancelled(); ++iteration)
    {
      this->reportProgress(iteration);
      Found found = this->look();
      if (this->roughlyThere(found, iteration) &&
        this->settle(found == Found::Step ? this->NewMultipliers : this->State.multipliers))
      {
        found = this->look();
      }
      this->observe(iteration);
      residuals.push_back(largest(this->Point.constraints) +
        this->Optimality / this->Model.gradientScale(this->Objective));
      ending = found == Found::Minimum ? Ending::Converged : Ending::Stalled;
      if (found == Found::Step && iteration >= this->Options.maximumIterations)
      {
        ending = standsStill(residuals) ? Ending::Stalled : Ending::Exhausted;
        break;
      }
      if (found != Found::Step || !(this->advance() || this->settle(this->NewMultipliers)))
      {
        break;
      }
    }
    this->State.ending =
      ending != Ending::Converged && this->cancelled() ? Ending::Cancelled : ending;
    return std::move(this->State);
  }

private:
  enum class Found
  {
    Minimum,
    Step,
    Nothing,
  };

  Found look()
  {
    const bool exact = this->TookStep && this->LargestMove < this->Options.exactWithin;
    this->linearize(exact ? Curvature::Exact : Curvature::Convex);
    return this->lookAround();
  }

  bool roughlyThere(Found found, int iteration) const
  {
    if (found != Found::Step)
    {
      return true;
    }
    return iteration >= this->Options.settleBy ||
      (largest(this->Point.constraints) <= this->Options.settleConstraint &&
        this->promised() <= this->Options.settlePromise * this->Objective);
  }

  /// Goes on with what the model settles for, as from a start.
  bool settle(const Eigen::VectorXd& multipliers)
  {
    if (this->Settled || this->cancelled())
    {
      return false;
    }
    this->Settled = true;
    if (!this->Model.settle(multipliers))
    {
      return false;
    }
    this->State.multipliers = multipliers;
    this->Objective = this->Model.objective(this->State.x, this->Run);
    this->Merit.forget();
    this->TookStep = false;
    return true;
  }

  Index unknownOf(std::size_t bounded) const
  {
    return this->FirstBounded + static_cast<Index>(bounded);
  }

  /// Who has said yes is not asked again.
  bool cancelled()
  {
    this->ToldToStop = this->ToldToStop || this->Run.cancelled();
    return this->ToldToStop;
  }

  void reportProgress(int iteration) const
  {
    if (this->Options.phase)
    {
      // Most runs take about five.
      this->Run.report(1.0 - std::pow(0.8, iteration), this->Options.phase);
    }
  }

  void observe(int iteration) const
  {
    if (this->Options.observe)
    {
      this->Options.observe({ iteration, this->Objective, largest(this->Point.constraints),
        this->Optimality, this->LargestMove, this->MeanMove, this->Taken == Curvature::Exact });
    }
  }

  void linearize(Curvature curvature)
  {
    this->Point = this->Model.linearize(
      this->State.x, this->State.multipliers, curvature, regularization, this->Run);
    this->Taken = curvature;
    this->Shift = 0.0;
    this->HeldStep.setZero();
    if (!this->Held.empty())
    {
      this->holdAtBounds();
    }
  }

  Eigen::VectorXd lagrangianGradient(const Eigen::VectorXd& multipliers) const
  {
    return this->Point.gradient + this->Model.transposedJacobianTimes(multipliers);
  }

  /// Holds the unknowns on a bound that are drawn outwards.
  void holdAtBounds()
  {
    const Eigen::VectorXd g = this->lagrangianGradient(this->State.multipliers);
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      const Index u = this->unknownOf(k);
      const double x = this->State.x[u];
      this->Held[k] = std::abs(x) >= this->Bounds[k] && g[u] * x <= 0.0 ? 1 : 0;
      if (this->Held[k])
      {
        this->Model.stiffen(static_cast<Index>(k), holdingStiffness);
      }
    }
  }

  /// Largest entry of the gradient of the Lagrangian over the unknowns that are free to move.
  double optimality(const Eigen::VectorXd& multipliers) const
  {
    Eigen::VectorXd g = this->lagrangianGradient(multipliers);
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      if (this->Held[k])
      {
        g[this->unknownOf(k)] = 0.0;
      }
    }
    return largest(g);
  }

  /// Whether the last step says by its size that no further one is worth it. Slivers and unknowns
  /// at their bound leave rounding in the gradient, not in the steps.
  bool still() const
  {
    return this->TookStep && this->TookWholeStep && this->LargestMove <= this->Options.stillMove;
  }

  bool feasible() const
  {
    return largest(this->Point.constraints) <
      (this->still() ? this->Options.stillConstraintTolerance : this->Options.constraintTolerance);
  }

  bool optimal(double optimality) const
  {
    return optimality <
      this->Options.optimalityTolerance * this->Model.gradientScale(this->Objective);
  }

  /// By how much the step would lower the objective.
  double promised() const { return 0.5 * std::abs(this->Point.gradient.dot(this->Step)); }

  /// Tests the point with the multipliers that the last step left, which spares solving, then with
  /// those of the step from here.
  Found lookAround()
  {
    this->Optimality = this->optimality(this->State.multipliers);
    const bool feasible = this->feasible();
    if (feasible && (this->still() || this->optimal(this->Optimality)))
    {
      return Found::Minimum;
    }
    if (!std::isfinite(this->Objective) || !this->solve())
    {
      return Found::Nothing;
    }
    if (!feasible)
    {
      return Found::Step;
    }
    const double optimality = this->optimality(this->NewMultipliers);
    if (this->promised() > this->Options.promiseTolerance * this->Objective &&
      !this->optimal(optimality))
    {
      return Found::Step;
    }
    this->State.multipliers = this->NewMultipliers;
    if (this->drawnInwards())
    {
      this->linearize(this->Taken);
      return this->solve() ? Found::Step : Found::Nothing;
    }
    this->Optimality = optimality;
    return Found::Minimum;
  }

  /// Whether the step's multipliers draw an unknown back that is held on its bound.
  bool drawnInwards() const
  {
    const Eigen::VectorXd g = this->lagrangianGradient(this->NewMultipliers);
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      const Index u = this->unknownOf(k);
      if (this->Held[k] && g[u] * (this->State.x[u] + this->HeldStep[Eigen::Index(k)]) > 0.0)
      {
        return true;
      }
    }
    return false;
  }

  bool factorizes()
  {
    return !this->cancelled() && this->Solver.factorize(this->Model.kkt(), this->Run) &&
      this->Solver.positive() == this->Unknowns;
  }

  /// Factors the KKT matrix with a Hessian that is convex on the constraints' tangent space.
  bool factorize()
  {
    bool done = this->factorizes();
    if (!done && this->Taken == Curvature::Exact && this->Model.hasConvexPart())
    {
      this->linearize(Curvature::Convex);
      done = this->factorizes();
    }
    double tau = this->Shift > 0.0 ? shiftGrowth * this->Shift
                                   : std::max(smallestShift, this->LastShift / shiftGrowth);
    for (; !done && tau <= largestShift && !this->cancelled(); tau *= shiftGrowth)
    {
      this->Model.shift(tau - this->Shift);
      this->Shift = tau;
      done = this->factorizes();
    }
    this->LastShift = this->Shift;
    return done;
  }

  /// Finds the Newton step and its multipliers.
  bool solve()
  {
    bool found = this->factorize() && this->solveStep();
    // An unknown that would leave its bounds goes as far as the bound, and the rest of the step
    // adapts.
    while (found && this->holdLeaving())
    {
      found = this->factorize() && this->solveStep();
    }
    return found;
  }

  bool solveStep()
  {
    Eigen::VectorXd rhs(this->Unknowns + this->Constraints);
    rhs.head(this->Unknowns) = -this->Point.gradient;
    rhs.tail(this->Constraints) = -this->Point.constraints;
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      if (this->Held[k])
      {
        rhs[this->unknownOf(k)] = holdingStiffness * this->HeldStep[static_cast<Eigen::Index>(k)];
      }
    }
    const Eigen::VectorXd solution = this->solveKkt(rhs);
    if (solution.size() != rhs.size() || !solution.allFinite())
    {
      return false;
    }
    this->Step = solution.head(this->Unknowns);
    // The multiplier part of the solution is the new multiplier itself.
    this->NewMultipliers = solution.tail(this->Constraints);
    return true;
  }

  bool holdLeaving()
  {
    bool leaving = false;
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      const Index u = this->unknownOf(k);
      if (!this->Held[k] && std::abs(this->State.x[u] + this->Step[u]) > this->Bounds[k])
      {
        this->Held[k] = 1;
        this->HeldStep[static_cast<Eigen::Index>(k)] =
          std::copysign(this->Bounds[k], this->Step[u]) - this->State.x[u];
        this->Model.stiffen(static_cast<Index>(k), holdingStiffness);
        leaving = true;
      }
    }
    return leaving;
  }

  /// Refined towards the system without the -delta block.
  Eigen::VectorXd solveKkt(const Eigen::VectorXd& rhs) const
  {
    Eigen::VectorXd x = this->Solver.solve(rhs);
    for (int refinement = 0; refinement < refinements && x.size() == rhs.size(); ++refinement)
    {
      Eigen::VectorXd r = rhs - this->Model.kkt().selfadjointView<Eigen::Lower>() * x;
      r.tail(this->Constraints) -= regularization * x.tail(this->Constraints);
      const Eigen::MatrixXd change = this->Solver.solve(r);
      if (change.rows() != x.size())
      {
        break;
      }
      x += change;
    }
    return x;
  }

  Eigen::VectorXd clipped(Eigen::VectorXd x) const
  {
    for (std::size_t k = 0; k < this->Bounds.size(); ++k)
    {
      double& value = x[this->unknownOf(k)];
      value = std::clamp(value, -this->Bounds[k], this->Bounds[k]);
    }
    return x;
  }

  /// Least change that takes back what the linear model left of the constraints at x.
  Eigen::VectorXd corrected(const Eigen::VectorXd& x) const
  {
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(this->Unknowns + this->Constraints);
    rhs.tail(this->Constraints) = -this->Model.constraints(x);
    const Eigen::VectorXd correction = this->solveKkt(rhs);
    return correction.size() == rhs.size() && correction.allFinite()
      ? this->clipped(x + correction.head(this->Unknowns))
      : x;
  }

  /// Goes along the step as far as the merit function falls.
  bool advance()
  {
    this->Merit.raise(this->NewMultipliers);
    const double violation = this->Merit.violation(this->Point.constraints);
    const double before = this->Objective + violation;
    const double slope = this->Point.gradient.dot(this->Step) - violation;
    // Below this a change of the merit function is rounding, and the Newton step is taken as it is.
    const double noise = objectiveRounding * (1.0 + std::abs(before)) +
      this->Merit.largestPenalty() * this->Model.constraintRounding(this->State.x, before);
    const double move = largest(this->Step);
    double scale = move > this->Options.longestMove ? this->Options.longestMove / move : 1.0;
    for (int halving = 0; halving < mostHalvings; ++halving, scale *= 0.5)
    {
      const double bound = before + sufficientDecrease * scale * std::min(slope, 0.0) + noise;
      const Eigen::VectorXd x = this->clipped(this->State.x + scale * this->Step);
      if (this->accept(x, bound, scale) ||
        (halving < this->Options.corrections && this->accept(this->corrected(x), bound, scale)))
      {
        return true;
      }
    }
    return false;
  }

  bool accept(const Eigen::VectorXd& x, double bound, double scale)
  {
    const double objective = this->Model.objective(x, this->Run);
    if (!(objective + this->Merit.violation(this->Model.constraints(x)) <= bound))
    {
      return false;
    }
    const Eigen::VectorXd move = x - this->State.x;
    this->LargestMove = largest(move);
    this->MeanMove = move.norm() / std::sqrt(std::max<double>(1.0, this->Unknowns));
    this->TookStep = true;
    this->TookWholeStep = scale == 1.0 && this->Shift == 0.0;
    this->Objective = objective;
    this->State.x = x;
    this->State.multipliers += scale * (this->NewMultipliers - this->State.multipliers);
    return true;
  }

  NewtonKktModel& Model;
  NewtonKktState State;
  LinearSolver Solver;
  const NewtonKktOptions& Options;
  const Execution& Run;
  std::vector<double> Bounds;
  Index Unknowns;
  Index Constraints;
  Index FirstBounded;
  std::vector<char> Held;   ///< bounded unknowns that are, or in this step go, to their bound
  Eigen::VectorXd HeldStep; ///< how far those go
  double Objective = 0.0;
  NewtonKktModel::Linearization Point;
  Curvature Taken = Curvature::Convex;
  double Optimality = 0.0;
  double Shift = 0.0;     ///< tau in the KKT matrix
  double LastShift = 0.0; ///< of the last factorization
  Eigen::VectorXd Step;
  Eigen::VectorXd NewMultipliers;
  MeritFunction Merit;
  double LargestMove = 0.0;
  double MeanMove = 0.0;
  bool TookStep = false; ///< since the objective is what it is
  bool TookWholeStep = false;
  bool Settled = false;
  bool ToldToStop = false;
};
}

NewtonKktState minimize(NewtonKktModel& model, NewtonKktState start, LinearSolver solver,
  const NewtonKktOptions& options, const Execution& execution)
{
  return Iteration(model, std::move(start), std::move(solver), options, execution).run();
}
}
