// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/PenaltyDescent.h"

#include "Sparse/NewtonKkt.h"
#include "Sparse/NewtonKktStep.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Weights of the squared constraints: the first leaves them out at first, the last leaves nothing
/// else; a start that nearly meets the constraints is not to leave them again.
constexpr double firstPenalty = 1.0;
constexpr double keepingPenalty = 1e4;
constexpr double lastPenalty = 1e10;
/// As of shifts: few descents, and starts that are near the next minimum.
constexpr double penaltyGrowth = 4.0;
/// With each weight until a further step promises to lower the whole by no more than this fraction
/// of it: on the way, and once the model has settled.
constexpr double roughly = 1e-2;
constexpr double nearly = 1e-5;
/// More steps with one weight than these gain less than the next weight does.
constexpr int maxStepsRoughly = 12;
constexpr int maxStepsNearly = 40;
constexpr int maxPenaltySaddles = 1; ///< left, with each weight
/// The shortest way off a saddle, as the largest move of an unknown.
constexpr double shortestPenaltyEscape = 1e-4;

class Descent
{
public:
  Descent(NewtonKktModel& model, const Eigen::VectorXd& start, LinearSolver solver,
    const PenaltyDescentOptions& options, const Execution& execution)
    : Model(model)
    , Options(options)
    , Run(execution)
    , Newton(model, std::move(solver), execution)
    , X(start)
    , Constraints(model.constraints(start))
    , StepsLeft(options.maxSteps)
  {
    this->Newton.enableSaddleHandling();
  }

  NewtonKktState run()
  {
    Termination termination = Termination::IterationLimit;
    this->Penalty = largest(this->Constraints) < this->Options.finalObjectiveConstraint
      ? keepingPenalty
      : firstPenalty;
    this->UsedPenalty = this->Penalty;
    while (
      termination == Termination::IterationLimit && this->Penalty <= lastPenalty && this->mayGoOn())
    {
      this->goDown();
      this->UsedPenalty = this->Penalty;
      if (this->Newton.cancelled())
      {
        termination = Termination::Cancelled;
      }
      else if (!this->switchToFinalObjective())
      {
        termination =
          this->HasFinalObjective && largest(this->Constraints) < this->Options.constraintTolerance
          ? Termination::Converged
          : termination;
        this->Penalty *= penaltyGrowth;
      }
    }
    return { this->X, this->UsedPenalty * this->Constraints, termination,
      this->Newton.factorizations() };
  }

private:
  bool mayGoOn() const
  {
    return this->StepsLeft > 0 &&
      this->Newton.factorizations() < this->Options.maximumFactorizations;
  }

  /// Whether the model is another one than before.
  bool switchToFinalObjective()
  {
    if (this->HasFinalObjective ||
      largest(this->Constraints) >= this->Options.finalObjectiveConstraint)
    {
      return false;
    }
    this->HasFinalObjective = true;
    return this->Model.switchToFinalObjective(this->Penalty * this->Constraints);
  }

  double merit(const Eigen::VectorXd& x, const Eigen::VectorXd& constraints) const
  {
    return this->Model.objective(x, this->Run) + 0.5 * this->Penalty * constraints.squaredNorm();
  }

  /// To a minimum with the weight as it is.
  void goDown()
  {
    this->Newton.setPenalty(this->Penalty);
    const double enough = this->HasFinalObjective ? nearly : roughly;
    int steps =
      std::min(this->StepsLeft, this->HasFinalObjective ? maxStepsNearly : maxStepsRoughly);
    int saddles = maxPenaltySaddles;
    bool further = true;
    for (; further && steps > 0 && this->mayGoOn() && !this->Newton.cancelled();
         --steps, --this->StepsLeft)
    {
      const double promised = this->step();
      further = promised > enough;
      if (!further && this->Newton.isIndefinite() && saddles-- > 0)
      {
        further = this->escapeSaddle();
      }
    }
  }

  /// \return what it promised over what there was; 0 where it led nowhere
  double step()
  {
    this->Newton.linearize(this->X, this->Penalty * this->Constraints, Curvature::Exact);
    if (!this->Newton.solve())
    {
      return 0.0;
    }
    const Eigen::VectorXd& step = this->Newton.step();
    const double slope = this->Newton.gradient().dot(step) +
      this->Constraints.dot(this->Newton.multipliers() - this->Penalty * this->Constraints);
    const double before = this->merit(this->X, this->Constraints);
    double scale = 1.0;
    for (int halving = 0; halving < maximumHalvings; ++halving, scale *= 0.5)
    {
      if (this->moveTo(this->Newton.clipped(this->X + scale * step),
            before + sufficientDecrease * scale * slope))
      {
        return -0.5 * slope / before;
      }
    }
    return 0.0;
  }

  /// Along the direction that bends downwards most.
  bool escapeSaddle()
  {
    const double before = this->merit(this->X, this->Constraints);
    this->Newton.linearize(this->X, this->Penalty * this->Constraints, Curvature::Exact);
    const Eigen::VectorXd direction = this->Newton.negativeCurvatureDirection();
    if (direction.size() == 0)
    {
      return false;
    }
    for (double length = 1.0; length > shortestPenaltyEscape; length *= 0.5)
    {
      for (const double signedLength : { length, -length })
      {
        if (this->moveTo(this->Newton.clipped(this->X + signedLength * direction), before))
        {
          return true;
        }
      }
    }
    return false;
  }

  bool moveTo(Eigen::VectorXd x, double bound)
  {
    Eigen::VectorXd constraints = this->Model.constraints(x);
    if (!(this->merit(x, constraints) < bound))
    {
      return false;
    }
    this->X = std::move(x);
    this->Constraints = std::move(constraints);
    return true;
  }

  NewtonKktModel& Model;
  const PenaltyDescentOptions& Options;
  const Execution& Run;
  NewtonKktStep Newton;
  Eigen::VectorXd X;
  Eigen::VectorXd Constraints;
  double Penalty = 0.0;
  double UsedPenalty = 0.0; ///< of the last descent
  int StepsLeft;
  bool HasFinalObjective = false;
};
}

NewtonKktState descend(NewtonKktModel& model, const Eigen::VectorXd& start, LinearSolver solver,
  const PenaltyDescentOptions& options, const Execution& execution)
{
  return Descent(model, start, std::move(solver), options, execution).run();
}
}
