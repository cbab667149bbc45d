// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/NewtonKkt.h"

#include "Sparse/NewtonKktStep.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// A step that has to be shorter than 2^-40 of Newton's is lost in rounding.
constexpr int mostHalvings = 40;
/// Corrections of one trial step, and what each has to leave of the constraints' violation at most.
constexpr int mostCorrections = 3;
constexpr double worthCorrecting = 0.25;
/// Rounding of the objective, a sum of some thousands of terms, as a fraction of it.
constexpr double objectiveRounding = 1e-13;
/// More saddles than these are not left by their own direction, but by rounding.
constexpr int mostSaddles = 5;
/// The shortest way off a saddle, as the largest move of an unknown, and how much of the objective
/// it has to bring at least.
constexpr double shortestEscape = 0.05;
constexpr double escapeFall = 1e-7;

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
      Found found = this->computeStep();
      const bool rough = this->roughlyThere(found, iteration);
      if (rough && found != Found::Step && this->switchToFinalObjective(this->State.multipliers))
      {
        found = this->computeStep();
      }
      this->observe(iteration);
      residuals.push_back(largest(this->Newton.constraints()) +
        this->Optimality / this->Model.gradientScale(this->Objective));
      termination = found == Found::Minimum ? Termination::Converged : Termination::Stalled;
      if (found == Found::Step &&
        (iteration >= this->Options.maximumIterations ||
          this->Newton.factorizations() >= this->Options.maximumFactorizations))
      {
        termination = hasStagnated(residuals) ? Termination::Stalled : Termination::IterationLimit;
        break;
      }
      if (found == Found::Step && this->atSaddle() && this->leaveSaddle())
      {
        continue;
      }
      if (found != Found::Step ||
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
  enum class Found
  {
    Minimum,
    Step,
    Nothing,
  };

  Found computeStep()
  {
    Found found = this->computeChordStep();
    if (found == Found::Nothing)
    {
      const double within = this->Settled
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
  Found computeChordStep()
  {
    if (this->Options.chordReduction == 0.0 || !this->TookStep || !this->TookWholeStep ||
      !this->Newton.follow(this->State.x, this->State.multipliers))
    {
      return Found::Nothing;
    }
    const double residual = this->residual(this->State.x, this->State.multipliers);
    if (!(residual <= this->Options.chordReduction * this->Residual))
    {
      return Found::Nothing;
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

  bool roughlyThere(Found found, int iteration) const
  {
    if (found != Found::Step)
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
    if (this->Settled || this->Newton.cancelled())
    {
      return false;
    }
    this->Settled = true;
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
  bool still() const
  {
    return this->TookStep && this->TookWholeStep &&
      this->LargestMove <= this->Options.stepTolerance;
  }

  bool feasible() const
  {
    return largest(this->Newton.constraints()) <
      (this->still() ? this->Options.stepConstraintTolerance : this->Options.constraintTolerance);
  }

  bool optimal(double optimality) const
  {
    return optimality <
      this->Options.optimalityTolerance * this->Model.gradientScale(this->Objective) ||
      optimality < this->Model.gradientRounding(this->State.x);
  }

  /// Tests the point with the multipliers that the last step left, which spares solving, then with
  /// those of the step from here.
  Found testOptimality()
  {
    this->Optimality = this->Newton.optimality(this->State.multipliers);
    const bool feasible = this->feasible();
    if (feasible && (this->still() || this->optimal(this->Optimality)))
    {
      return Found::Minimum;
    }
    if (!std::isfinite(this->Objective) || !this->Newton.solve())
    {
      return Found::Nothing;
    }
    if (!feasible)
    {
      return Found::Step;
    }
    const double optimality = this->Newton.optimality(this->Newton.multipliers());
    if (this->Newton.predictedReduction() > this->Options.reductionTolerance * this->Objective &&
      !this->optimal(optimality))
    {
      return Found::Step;
    }
    this->State.multipliers = this->Newton.multipliers();
    if (this->Newton.shouldLeaveActiveSet())
    {
      this->linearize(this->Newton.curvature());
      return this->Newton.solve() ? Found::Step : Found::Nothing;
    }
    this->Optimality = optimality;
    return Found::Minimum;
  }

  /// Goes along the step as far as the merit function falls.
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
    for (int halving = 0; halving < mostHalvings; ++halving, scale *= 0.5)
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
  bool atSaddle() const
  {
    return this->SaddlesLeft < mostSaddles && this->Newton.isIndefinite() &&
      largest(this->Newton.constraints()) <= this->Options.finalObjectiveConstraint &&
      this->Newton.predictedReduction() <= this->Options.saddleReduction * this->Objective;
  }

  /// Along the direction that bends downwards most, to the side and as far as it falls.
  bool leaveSaddle()
  {
    ++this->SaddlesLeft;
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
    for (int correction = 0; correction < mostCorrections; ++correction)
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
    this->take(x, objective, scale);
    return true;
  }

  /// Near a minimum a whole step may raise the merit function because constraints bend (the effect
  /// of Maratos), and a correction of each costs more than the step. It is as good where it can be
  /// followed: where what is left of the conditions of a minimum falls as much as it has to then.
  bool acceptByResidual(const Eigen::VectorXd& x, double objective)
  {
    if (this->Options.chordReduction == 0.0 || !this->Newton.nearMinimum() ||
      !(largest(this->Newton.step()) < this->Options.exactWithin) ||
      !this->Newton.follow(x, this->Newton.multipliers()))
    {
      return false;
    }
    if (std::isfinite(objective) &&
      this->residual(x, this->Newton.multipliers()) <=
        this->Options.chordReduction * this->Residual)
    {
      this->take(x, objective, 1.0);
      return true;
    }
    this->Newton.follow(this->State.x, this->State.multipliers);
    return false;
  }

  void take(const Eigen::VectorXd& x, double objective, double scale)
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
  bool Settled = false;
  bool Shortened = false; ///< corrections of this step
  int SaddlesLeft = 0;
};
}

NewtonKktState minimize(NewtonKktModel& model, NewtonKktState start, LinearSolver solver,
  const NewtonKktOptions& options, const Execution& execution)
{
  return Iteration(model, std::move(start), std::move(solver), options, execution).run();
}
}
