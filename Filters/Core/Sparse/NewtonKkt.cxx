// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/NewtonKkt.h"

#include "Sparse/NewtonKktStep.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Corrections of one trial step, and what each has to leave of the constraints' violation at most.
constexpr int maxCorrections = 3;
constexpr double worthCorrecting = 0.25;
/// Rounding of the objective, a sum of some thousands of terms, as a fraction of it.
constexpr double objectiveRounding = 1e-13;
/// More saddles than these are not left by their own direction, but by rounding.
constexpr int maxSaddles = 5;
/// The shortest way off a saddle, as the largest move of an unknown, and how much of the objective
/// it has to bring at least.
constexpr double shortestEscape = 0.05;
constexpr double escapeFall = 1e-7;

/// Whether an iteration has got no nearer to zero in the second half of its run than in the first.
/// \param residuals of at least 40 iterations; of fewer nothing is known
bool hasStagnated(const std::vector<double>& residuals)
{
  constexpr std::size_t fewest = 40;
  constexpr double noticeable = 0.9;
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  return residuals.size() >= fewest &&
    *std::min_element(middle, residuals.end()) >=
    noticeable * *std::min_element(residuals.begin(), middle);
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
    const double least = this->Share * largest(asked);
    this->Penalties =
      this->Penalties.cwiseMax((asked.array().max(least) + smallestPenalty).matrix());
  }
  void forget() { this->Penalties.setZero(); }

  double violation(const Eigen::VectorXd& constraints) const
  {
    return constraints.cwiseAbs().dot(this->Penalties);
  }
  double largestPenalty() const { return largest(this->Penalties); }

private:
  /// Where no multiplier asks for one.
  static constexpr double smallestPenalty = 1e-3;

  Eigen::VectorXd Penalties;
  double Margin;
  double Share;
};

class Iteration
{
public:
  Iteration(NewtonKktModel& model, NewtonKktState start, LinearSolver solver,
    const NewtonKktOptions& options, const Execution& execution)
    : Model(model)
    , State(std::move(start))
    , Options(options)
    , Run(execution)
    , Newton(model, std::move(solver), execution)
    , Merit(model.constraintCount(), options.penaltyMargin, options.penaltyShare)
  {
    if (options.chordReduction > 0.0)
    {
      this->Newton.enableChordSteps();
    }
    if (options.amongSaddles)
    {
      this->Newton.enableSaddleHandling();
    }
    if (this->State.multipliers.size() != model.constraintCount())
    {
      this->State.multipliers = Eigen::VectorXd::Zero(model.constraintCount());
    }
  }

  NewtonKktState run()
  {
    this->Objective = this->Model.objective(this->State.x, this->Run);
    Termination termination = Termination::Cancelled;
    std::vector<double> residuals;
    for (int iteration = 0; !this->Newton.cancelled(); ++iteration)
    {
      this->reportProgress(iteration);
      StepResult found = this->computeStep();
      const bool rough = this->isRoughlyOptimal(found, iteration);
      if (rough && found != StepResult::Step &&
        this->switchToFinalObjective(this->State.multipliers))
      {
        found = this->computeStep();
      }
      this->observe(iteration);
      residuals.push_back(largest(this->Newton.constraints()) +
        this->Optimality / this->Model.gradientScale(this->Objective));
      termination = found == StepResult::Minimum ? Termination::Converged : Termination::Stalled;
      if (found == StepResult::Step &&
        (iteration >= this->Options.maximumIterations ||
          this->Newton.factorizations() >= this->Options.maximumFactorizations))
      {
        termination = hasStagnated(residuals) ? Termination::Stalled : Termination::IterationLimit;
        break;
      }
      if (found == StepResult::Step && this->isAtSaddle() && this->escapeSaddle())
      {
        continue;
      }
      if (found != StepResult::Step ||
        !(this->advance() || this->switchToFinalObjective(this->Newton.multipliers())))
      {
        break;
      }
      if (rough)
      {
        this->switchToFinalObjective(this->Newton.multipliers());
      }
    }
    this->State.termination = termination != Termination::Converged && this->Newton.cancelled()
      ? Termination::Cancelled
      : termination;
    this->State.factorizations = this->Newton.factorizations();
    return std::move(this->State);
  }

private:
  enum class StepResult
  {
    Minimum,
    Step,
    Nothing,
  };

  StepResult computeStep()
  {
    StepResult found = this->computeChordStep();
    if (found == StepResult::Nothing)
    {
      const double within = this->HasFinalObjective
        ? this->Options.exactWithin
        : std::min(this->Options.exactWithin, this->Options.exactBeforeSettling);
      const bool exact = this->Moved && this->LargestMove < within;
      this->linearize(exact ? Curvature::Exact : Curvature::Convex);
      this->Residual = this->residual(this->State.x, this->State.multipliers);
      found = this->testOptimality();
    }
    return found;
  }

  /// With the last factorization, as long as such steps lead on quickly.
  StepResult computeChordStep()
  {
    if (this->Options.chordReduction == 0.0 || !this->TookStep || !this->TookWholeStep ||
      !this->Newton.linearizeForChord(this->State.x, this->State.multipliers))
    {
      return StepResult::Nothing;
    }
    const double residual = this->residual(this->State.x, this->State.multipliers);
    if (!(residual <= this->Options.chordReduction * this->Residual))
    {
      return StepResult::Nothing;
    }
    this->Residual = residual;
    return this->testOptimality();
  }

  /// How far the point that was linearized last is from one that meets the conditions of a minimum,
  /// rounding left out.
  double residual(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers) const
  {
    const double gradient =
      std::max(0.0, this->Newton.optimality(multipliers) - this->Model.gradientRounding(x));
    return largest(this->Newton.constraints()) +
      gradient / this->Model.gradientScale(this->Objective);
  }

  bool isRoughlyOptimal(StepResult found, int iteration) const
  {
    if (found != StepResult::Step)
    {
      return true;
    }
    return iteration >= this->Options.finalObjectiveIteration ||
      (largest(this->Newton.constraints()) <= this->Options.finalObjectiveConstraint &&
        this->Newton.predictedReduction() <=
          this->Options.finalObjectiveReduction * this->Objective);
  }

  /// Goes on with what the model settles for, as from a start.
  bool switchToFinalObjective(const Eigen::VectorXd& multipliers)
  {
    if (this->HasFinalObjective || this->Newton.cancelled())
    {
      return false;
    }
    this->HasFinalObjective = true;
    if (!this->Model.switchToFinalObjective(multipliers))
    {
      return false;
    }
    this->State.multipliers = multipliers;
    this->Objective = this->Model.objective(this->State.x, this->Run);
    this->Merit.forget();
    this->TookStep = false;
    return true;
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
      this->Options.observe(
        { iteration, this->Objective, largest(this->Newton.constraints()), this->Optimality,
          this->LargestMove, this->MeanMove, this->Newton.curvature() == Curvature::Exact });
    }
  }

  void linearize(Curvature curvature)
  {
    this->Newton.linearize(this->State.x, this->State.multipliers, curvature);
  }

  /// Whether the last step says by its size that no further one is worth it. Slivers and unknowns
  /// at their bound leave rounding in the gradient, not in the steps.
  bool stepsVanish() const
  {
    return this->TookStep && this->TookWholeStep &&
      this->LargestMove <= this->Options.stepTolerance;
  }

  bool isFeasible() const
  {
    return largest(this->Newton.constraints()) < (this->stepsVanish()
                                                     ? this->Options.stepConstraintTolerance
                                                     : this->Options.constraintTolerance);
  }

  bool isOptimal(double optimality) const
  {
    return optimality <
      this->Options.optimalityTolerance * this->Model.gradientScale(this->Objective) ||
      optimality < this->Model.gradientRounding(this->State.x);
  }

  /// Tests the point with the multipliers that the last step left, which spares solving, then with
  /// those of the step from here.
  StepResult testOptimality()
  {
    this->Optimality = this->Newton.optimality(this->State.multipliers);
    const bool feasible = this->isFeasible();
    if (feasible && (this->stepsVanish() || this->isOptimal(this->Optimality)))
    {
      return StepResult::Minimum;
    }
    if (!std::isfinite(this->Objective) || !this->Newton.solve())
    {
      return StepResult::Nothing;
    }
    if (!feasible)
    {
      return StepResult::Step;
    }
    const double optimality = this->Newton.optimality(this->Newton.multipliers());
    if (this->Newton.predictedReduction() > this->Options.reductionTolerance * this->Objective &&
      !this->isOptimal(optimality))
    {
      return StepResult::Step;
    }
    this->State.multipliers = this->Newton.multipliers();
    if (this->Newton.shouldLeaveActiveSet())
    {
      this->linearize(this->Newton.curvature());
      return this->Newton.solve() ? StepResult::Step : StepResult::Nothing;
    }
    this->Optimality = optimality;
    return StepResult::Minimum;
  }

  /// Takes the longest part of the step by which the merit function falls.
  bool advance()
  {
    this->Merit.raise(this->Newton.multipliers());
    const Eigen::VectorXd& step = this->Newton.step();
    const double violation = this->Merit.violation(this->Newton.constraints());
    const double before = this->Objective + violation;
    const double slope = this->Newton.gradient().dot(step) - violation;
    // Below this a change of the merit function is rounding, and the Newton step is taken as it is.
    const double noise = objectiveRounding * (1.0 + std::abs(before)) +
      this->Merit.largestPenalty() * this->Model.constraintRounding(this->State.x, before);
    const double move = largest(step);
    double scale = move > this->Options.maximumMove ? this->Options.maximumMove / move : 1.0;
    this->Shortened = false;
    for (int halving = 0; halving < maximumHalvings; ++halving, scale *= 0.5)
    {
      const double bound = before + sufficientDecrease * scale * std::min(slope, 0.0) + noise;
      const Eigen::VectorXd x = this->Newton.clipped(this->State.x + scale * step);
      if (this->accept(x, bound, scale) ||
        (scale == 1.0 && this->acceptByResidual(x, this->TriedObjective)) ||
        (halving < this->Options.corrections && this->acceptCorrected(x, bound, scale)))
      {
        return true;
      }
    }
    return false;
  }

  /// Whether a step would bring next to nothing where the Hessian bends downwards: Newton's method
  /// goes to saddles as well.
  bool isAtSaddle() const
  {
    return this->SaddlesEscaped < maxSaddles && this->Newton.isIndefinite() &&
      largest(this->Newton.constraints()) <= this->Options.finalObjectiveConstraint &&
      this->Newton.predictedReduction() <= this->Options.saddleReduction * this->Objective;
  }

  /// Along the direction that bends downwards most, to the side on which it falls.
  bool escapeSaddle()
  {
    ++this->SaddlesEscaped;
    const Eigen::VectorXd direction = this->Newton.negativeCurvatureDirection();
    if (direction.size() == 0)
    {
      return false;
    }
    this->Merit.raise(this->Newton.multipliers());
    const double before = this->Objective + this->Merit.violation(this->Newton.constraints());
    for (double length = 1.0; length > shortestEscape; length *= 0.5)
    {
      for (const double signedLength : { length, -length })
      {
        const Eigen::VectorXd x = this->Newton.clipped(this->State.x + signedLength * direction);
        if (this->accept(this->Newton.corrected(x), before * (1.0 - escapeFall), 1.0))
        {
          this->TookWholeStep = false;
          return true;
        }
      }
    }
    return false;
  }

  /// With the constraints' curvature taken out. A correction leaves an error of third order, and
  /// where the sheet is soft a step promises less than that costs: it is corrected again as long as
  /// that helps, and by shorter corrections where it does not.
  bool acceptCorrected(const Eigen::VectorXd& tried, double bound, double scale)
  {
    Eigen::VectorXd x = tried;
    double violation = this->Merit.violation(this->Model.constraints(x));
    for (int correction = 0; correction < maxCorrections; ++correction)
    {
      x = this->Newton.corrected(x);
      if (this->accept(x, bound, scale))
      {
        return true;
      }
      if (!this->Options.correctsAgain)
      {
        return false;
      }
      const double left = this->Merit.violation(this->Model.constraints(x));
      if (!(left <= worthCorrecting * violation))
      {
        const bool again = !this->Shortened && this->Newton.shortenCorrections();
        this->Shortened = true;
        return again && this->acceptCorrected(tried, bound, scale);
      }
      violation = left;
    }
    return false;
  }

  bool accept(const Eigen::VectorXd& x, double bound, double scale)
  {
    const double objective = this->Model.objective(x, this->Run);
    this->TriedObjective = objective;
    if (!(objective + this->Merit.violation(this->Model.constraints(x)) <= bound))
    {
      return false;
    }
    this->moveTo(x, objective, scale);
    return true;
  }

  /// Near a minimum a whole step may raise the merit function because constraints bend (the effect
  /// of Maratos), and a correction of each costs more than the step. It is as good where it can be
  /// followed: where what is left of the conditions of a minimum falls as much as it has to then.
  bool acceptByResidual(const Eigen::VectorXd& x, double objective)
  {
    if (this->Options.chordReduction == 0.0 || !this->Newton.nearMinimum() ||
      !(largest(this->Newton.step()) < this->Options.exactWithin) ||
      !this->Newton.linearizeForChord(x, this->Newton.multipliers()))
    {
      return false;
    }
    if (std::isfinite(objective) &&
      this->residual(x, this->Newton.multipliers()) <=
        this->Options.chordReduction * this->Residual)
    {
      this->moveTo(x, objective, 1.0);
      return true;
    }
    this->Newton.linearizeForChord(this->State.x, this->State.multipliers);
    return false;
  }

  void moveTo(const Eigen::VectorXd& x, double objective, double scale)
  {
    const Eigen::VectorXd move = x - this->State.x;
    this->LargestMove = largest(move);
    this->MeanMove =
      move.norm() / std::sqrt(std::max<double>(1.0, static_cast<double>(move.size())));
    this->Newton.updateDamping(scale);
    this->Moved = true;
    this->TookStep = true;
    this->TookWholeStep = scale == 1.0 && this->Newton.shift() == 0.0;
    this->Objective = objective;
    this->State.x = x;
    this->State.multipliers += scale * (this->Newton.multipliers() - this->State.multipliers);
  }

  NewtonKktModel& Model;
  NewtonKktState State;
  const NewtonKktOptions& Options;
  const Execution& Run;
  NewtonKktStep Newton;
  MeritFunction Merit;
  double Objective = 0.0;
  double TriedObjective = 0.0; ///< of the point that the merit function was last asked about
  double Optimality = 0.0;
  double Residual = 0.0; ///< of the last point that was looked at
  double LargestMove = 0.0;
  double MeanMove = 0.0;
  bool Moved = false;
  bool TookStep = false; ///< since the objective is what it is
  bool TookWholeStep = false;
  bool HasFinalObjective = false;
  bool Shortened = false; ///< corrections of this step
  int SaddlesEscaped = 0;
};
}

NewtonKktState minimize(NewtonKktModel& model, NewtonKktState start, LinearSolver solver,
  const NewtonKktOptions& options, const Execution& execution)
{
  return Iteration(model, std::move(start), std::move(solver), options, execution).run();
}
}
