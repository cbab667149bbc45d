// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/NewtonAngleSolver.h"

#include "Angles/DirectionsKkt.h"
#include "Sparse/LinearSolver.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
constexpr double regularization = 1e-8; ///< delta of the constraint block
constexpr double longestStep = 1.0;     ///< radians an edge may turn in one step

class NewtonIteration
{
public:
  NewtonIteration(const DirectionsForm& form, const AngleProblem& problem, NewtonState start)
    : Form(form)
    , Problem(problem)
    , State(std::move(start))
    , Unknowns(form.unknownCount())
    , Constraints(form.constraintCount())
    , Held(form.groupCount(), 0)
    , Kkt(form)
    , Solver(LeadingColumns{ form.rotationsAlongWires() })
  {
    if (this->State.multipliers.size() != this->Constraints)
    {
      this->State.multipliers = Eigen::VectorXd::Zero(this->Constraints);
    }
  }

  NewtonState run(const AngleSolverOptions& options, const Execution& execution, const char* phase,
    std::vector<IterationRecord>& history)
  {
    const double size = perimeter(this->Problem) / this->Form.unit();
    double stepSize = 0.0;
    std::vector<double> residuals;
    for (int iteration = 0;; ++iteration)
    {
      this->linearize();
      IterationRecord record;
      record.phase = phase;
      record.objective = this->Objective;
      record.closure = this->Closure.size() ? this->Closure.cwiseAbs().maxCoeff() / size : 0.0;
      record.optimality = this->optimality();
      record.step = stepSize;
      history.push_back(record);
      if (record.closure < options.closureTolerance &&
        record.optimality < options.optimalityTolerance && !this->releaseHeld())
      {
        this->State.ending = Ending::Converged;
        break;
      }
      residuals.push_back(record.closure + record.optimality);
      if (iteration >= options.maximumIterations)
      {
        this->State.ending = standsStill(residuals) ? Ending::Stalled : Ending::Exhausted;
        break;
      }
      if (execution.cancelled())
      {
        this->State.ending = Ending::Cancelled;
        break;
      }
      if (!std::isfinite(record.objective) || !this->solveStep() || !this->advance(stepSize))
      {
        this->State.ending = Ending::Stalled;
        break;
      }
    }
    return std::move(this->State);
  }

private:
  Index groupUnknown(std::size_t g) const
  {
    return this->Form.rotationCount() + static_cast<Index>(g);
  }

  void linearize()
  {
    this->Objective = this->Form.objective(this->State.x);
    this->Gradient = this->Form.gradient(this->State.x);
    this->Units = this->Form.unitVectors(this->State.x);
    this->Closure = this->Form.closure(this->State.x, this->Units);
  }

  Eigen::VectorXd lagrangianGradient() const
  {
    return this->Gradient +
      this->Kkt.transposedJacobianTimes(this->State.x, this->Units, this->State.multipliers);
  }

  /// Largest entry of the gradient of the Lagrangian over the unknowns that are free to move.
  double optimality() const
  {
    Eigen::VectorXd g = this->lagrangianGradient();
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      if (this->Held[k])
      {
        g[this->groupUnknown(k)] = 0.0;
      }
    }
    return g.size() ? g.cwiseAbs().maxCoeff() : 0.0;
  }

  /// Frees stretches that sit on a bound but pull inwards; true where there was one.
  bool releaseHeld()
  {
    const Eigen::VectorXd g = this->lagrangianGradient();
    bool released = false;
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      const double pull = -g[this->groupUnknown(k)] * this->State.x[this->groupUnknown(k)];
      if (this->Held[k] && pull < 0.0)
      {
        this->Held[k] = 0;
        released = true;
      }
    }
    return released;
  }

  /// Residual of the true KKT system (without the -delta block) for a solution of it.
  Eigen::VectorXd kktResidual(const Eigen::VectorXd& x, const Eigen::VectorXd& rhs) const
  {
    Eigen::VectorXd r = rhs - this->Kkt.matrix().selfadjointView<Eigen::Lower>() * x;
    r.tail(this->Constraints) -= regularization * x.tail(this->Constraints);
    return r;
  }

  Eigen::VectorXd solveKkt(const Eigen::VectorXd& rhs) const
  {
    Eigen::VectorXd x = this->Solver.solve(rhs);
    for (int refinement = 0; refinement < 2 && x.size() == rhs.size(); ++refinement)
    {
      const Eigen::MatrixXd change = this->Solver.solve(this->kktResidual(x, rhs));
      if (change.rows() != x.size())
      {
        break;
      }
      x += change;
    }
    return x;
  }

  /// Factors the KKT matrix with a tau that makes the model convex on the constraints' tangent
  /// space.
  bool factorize()
  {
    this->Kkt.fill(this->State.x, this->Units, this->State.multipliers, this->Held, regularization);
    double tau = 0.0;
    for (int attempt = 0; attempt < 40; ++attempt)
    {
      if (this->Solver.factorize(this->Kkt.matrix()) && this->Solver.positive() == this->Unknowns)
      {
        this->LastTau = tau;
        return true;
      }
      const double larger = tau > 0.0 ? 4.0 * tau : std::max(1e-4, this->LastTau / 4.0);
      this->Kkt.shift(larger - tau);
      tau = larger;
    }
    return false;
  }

  bool solveStep()
  {
    if (!this->factorize())
    {
      return false;
    }
    Eigen::VectorXd rhs(this->Unknowns + this->Constraints);
    rhs.head(this->Unknowns) = -this->Gradient;
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      if (this->Held[k])
      {
        rhs[this->groupUnknown(k)] = 0.0;
      }
    }
    rhs.tail(this->Constraints) = -this->Closure;
    // The multiplier part of the solution is the new multiplier itself.
    const Eigen::VectorXd solution = this->solveKkt(rhs);
    if (solution.size() != rhs.size() || !solution.allFinite())
    {
      return false;
    }
    this->Step = solution.head(this->Unknowns);
    this->NewMultipliers = solution.tail(this->Constraints);
    return true;
  }

  double merit(const Eigen::VectorXd& x) const
  {
    return this->Form.objective(x) + this->Penalty * this->Form.closure(x).lpNorm<1>();
  }

  Eigen::VectorXd clipped(Eigen::VectorXd x) const
  {
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      double& h = x[this->groupUnknown(k)];
      h = std::clamp(h, -this->Problem.groups[k].tolerance, this->Problem.groups[k].tolerance);
    }
    return x;
  }

  /// Least change that takes back the closure error which the linear model left at x.
  Eigen::VectorXd corrected(const Eigen::VectorXd& x) const
  {
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(this->Unknowns + this->Constraints);
    rhs.tail(this->Constraints) = -this->Form.closure(x);
    const Eigen::VectorXd correction = this->solveKkt(rhs);
    return correction.size() == rhs.size() && correction.allFinite()
      ? this->clipped(x + correction.head(this->Unknowns))
      : x;
  }

  bool advance(double& stepSize)
  {
    const double turn = this->Unknowns ? this->Step.cwiseAbs().maxCoeff() : 0.0;
    double scale = turn > longestStep ? longestStep / turn : 1.0;
    const double violation = this->Closure.lpNorm<1>();
    const double largest =
      this->NewMultipliers.size() ? this->NewMultipliers.cwiseAbs().maxCoeff() : 0.0;
    this->Penalty = std::max(this->Penalty, 1.5 * largest + 1e-3);
    const double before = this->Objective + this->Penalty * violation;
    const double slope = this->Gradient.dot(this->Step) - this->Penalty * violation;
    // Below this a change of the merit function is rounding, and the Newton step is taken as it is.
    const double noise = 1e-13 * (1.0 + std::abs(before)) * (1.0 + this->Penalty);
    for (int halving = 0; halving < 30; ++halving, scale *= 0.5)
    {
      const Eigen::VectorXd x = this->clipped(this->State.x + scale * this->Step);
      const double bound = before + 1e-4 * scale * std::min(slope, 0.0) + noise;
      if (this->merit(x) <= bound)
      {
        return this->accept(x, scale, stepSize);
      }
      if (halving == 0)
      {
        const Eigen::VectorXd second = this->corrected(x);
        if (this->merit(second) <= bound)
        {
          return this->accept(second, scale, stepSize);
        }
      }
    }
    return false;
  }

  bool accept(const Eigen::VectorXd& x, double scale, double& stepSize)
  {
    stepSize = (x - this->State.x).norm() /
      std::sqrt(std::max<double>(1.0, static_cast<double>(this->Unknowns)));
    this->State.x = x;
    this->State.multipliers += scale * (this->NewMultipliers - this->State.multipliers);
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      const double tolerance = this->Problem.groups[k].tolerance;
      this->Held[k] = std::abs(x[this->groupUnknown(k)]) >= tolerance ? 1 : 0;
    }
    return true;
  }

  const DirectionsForm& Form;
  const AngleProblem& Problem;
  NewtonState State;
  Index Unknowns;
  Index Constraints;
  std::vector<char> Held; ///< stretches that sit on their bound
  DirectionsKkt Kkt;
  double Objective = 0.0;
  Points2 Units; ///< directions of the wire edges
  Eigen::VectorXd Gradient;
  Eigen::VectorXd Closure;
  LinearSolver Solver;
  Eigen::VectorXd Step;
  Eigen::VectorXd NewMultipliers;
  double Penalty = 0.0;
  double LastTau = 0.0;
};
}

NewtonState solveAnglesByNewton(const DirectionsForm& form, const AngleProblem& problem,
  NewtonState start, const AngleSolverOptions& options, const Execution& execution,
  const char* phase, std::vector<IterationRecord>& history)
{
  return NewtonIteration(form, problem, std::move(start)).run(options, execution, phase, history);
}
}
