// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/IsometricWarping.h"

#include "Base/Ending.h"
#include "Embedding/WireLayout.h"
#include "Sparse/LinearSolver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
constexpr double regularization = 1e-8; ///< delta of the constraint block
constexpr double constraintTolerance = 1e-10;
/// A whole Newton step that moves no vertex by more, in the model's unit of length, is the last;
/// what it leaves of the lengths' errors is taken out by correctWireLengths().
constexpr double shortestStep = 1e-10;
constexpr double stillTolerance = 1e-8;

IsometricSolution cancelledSolution()
{
  IsometricSolution solution;
  solution.status = { StatusCode::Cancelled, "cancelled while solving for the piece", {} };
  return solution;
}

class IsometricIterations
{
public:
  IsometricIterations(IsometricModel& model, const AngleProblem& problem,
    const IsometricOptions& options, const Execution& execution)
    : Model(model)
    , Problem(problem)
    , Options(options)
    , Run(execution)
    , Unknowns(model.unknownCount())
    , Constraints(model.constraintCount())
    , Held(model.groupCount(), 0)
    , HeldStep(Eigen::VectorXd::Zero(model.groupCount()))
  {
  }

  IsometricSolution run(Eigen::VectorXd x)
  {
    IsometricSolution solution;
    this->X = std::move(x);
    if (this->Run.cancelled())
    {
      return cancelledSolution();
    }
    this->Solver = LinearSolver(this->Model.eliminationOrder(this->X));
    this->holdAtBounds();
    this->Multipliers = Eigen::VectorXd::Zero(this->Constraints);
    bool converged = false;
    bool exhausted = false;
    std::vector<double> residuals;
    double moved = 0.0;
    // Far from the minimum the exact Hessian is seldom convex; it pays once steps are short.
    bool exact = false;
    for (int iteration = 0;; ++iteration)
    {
      if (this->Run.cancelled())
      {
        return cancelledSolution();
      }
      // Most pieces take about five.
      this->Run.report(1.0 - std::pow(0.8, iteration), "Warping wires and interior together");
      this->Terms = this->Model.objective(this->X, this->Run);
      if (!std::isfinite(this->Terms.total) || !this->solve(exact))
      {
        break;
      }
      const double violation = largest(this->Point.constraints);
      const double optimality = this->optimality();
      solution.history.push_back(
        { this->Terms.total, violation, optimality, moved, this->UsedExact });
      solution.iterations = iteration;
      // Slivers and elastic curves at their bound leave rounding in the gradient, not in the steps.
      const bool still = this->TookWholeStep && moved <= shortestStep;
      // A developable piece has no energy; the floor is what rounding leaves of the gradient.
      const double scale = std::max(std::sqrt(this->Terms.total), 1e-2);
      const bool stationary = still || optimality <= this->Options.tolerance * scale ||
        this->promise() <= this->Options.tolerance * this->Options.tolerance * this->Terms.total;
      const double allowed = still ? stillTolerance : constraintTolerance;
      if (violation <= allowed && stationary && !this->releaseHeld())
      {
        converged = true;
        break;
      }
      residuals.push_back(violation + optimality / scale);
      if (iteration == this->Options.maximumIterations)
      {
        exhausted = !standsStill(residuals);
        break;
      }
      if (!this->advance(moved))
      {
        break;
      }
      exact = moved < 1.0;
    }
    if (!converged && this->Run.cancelled())
    {
      return cancelledSolution();
    }
    this->Terms = this->Model.objective(this->X, this->Run);
    solution.positions = this->Model.positions(this->X);
    solution.stretch = this->Model.stretches(this->X);
    solution.distortionEnergy = this->Terms.sheet;
    solution.angleEnergy = this->Terms.angles;
    if (!converged)
    {
      const std::string iterations = std::to_string(solution.iterations) + " iterations";
      solution.status = { StatusCode::NotConverged,
        exhausted ? "the isometric scheme did not converge in " + iterations
                  : "the isometric scheme stopped short of a minimum after " + iterations +
            ", and more would change nothing",
        {}, exhausted ? WaysOut{ Remedy::AllowIsometricIterations } : WaysOut{} };
    }
    return solution;
  }

private:
  static double largest(const Eigen::VectorXd& v)
  {
    return v.size() ? v.cwiseAbs().maxCoeff() : 0.0;
  }

  Index groupUnknown(std::size_t g) const
  {
    return this->Model.coordinateCount() + static_cast<Index>(g);
  }

  Eigen::VectorXd lagrangianGradient(const Eigen::VectorXd& multipliers) const
  {
    Eigen::VectorXd g = this->Point.gradient + this->Model.transposedJacobianTimes(multipliers);
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      if (this->Held[k])
      {
        g[this->groupUnknown(k)] = 0.0;
      }
    }
    return g;
  }

  double optimality() const { return largest(this->lagrangianGradient(this->NewMultipliers)); }

  /// What the quadratic model expects the merit function to fall by.
  double promise() const { return std::abs(this->Point.gradient.dot(this->Step)) * 0.5; }

  bool releaseHeld()
  {
    const Eigen::VectorXd g =
      this->Point.gradient + this->Model.transposedJacobianTimes(this->NewMultipliers);
    bool released = false;
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      const Index u = this->groupUnknown(k);
      if (this->Held[k] && g[u] * this->X[u] > 0.0)
      {
        this->Held[k] = 0;
        released = true;
      }
    }
    return released;
  }

  bool factorize(IsometricModel::Curvature curvature, double tau)
  {
    this->Point =
      this->Model.linearize(this->X, this->Multipliers, curvature, regularization, this->Run);
    this->Model.fixMotion(this->X);
    this->Model.shift(tau);
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      if (this->Held[k])
      {
        this->Model.hold(static_cast<Index>(k));
      }
    }
    return !this->Run.cancelled() && this->Solver.factorize(this->Model.kkt(), this->Run) &&
      this->Solver.positive() == this->Unknowns;
  }

  /// Solves the KKT system at X with a Hessian that is convex on the constraints' tangent space.
  bool solve(bool exact)
  {
    this->UsedExact = exact && this->factorize(IsometricModel::Curvature::Exact, 0.0);
    this->Shift = 0.0;
    bool factored = this->UsedExact;
    for (double tau = 0.0; !factored && tau < 1e6; tau = std::max(1e-4, 10.0 * tau))
    {
      if (this->Run.cancelled())
      {
        return false;
      }
      factored = this->factorize(IsometricModel::Curvature::Convex, tau);
      this->Shift = tau;
    }
    if (!factored || this->Run.cancelled())
    {
      return false;
    }
    Eigen::VectorXd rhs(this->Unknowns + this->Constraints);
    rhs.head(this->Unknowns) = -this->Point.gradient;
    rhs.tail(this->Constraints) = -this->Point.constraints;
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      if (this->Held[k])
      {
        rhs[this->groupUnknown(k)] =
          IsometricModel::heldStiffness * this->HeldStep[static_cast<Index>(k)];
      }
    }
    const Eigen::VectorXd solution = this->solveKkt(rhs);
    if (solution.size() != rhs.size() || !solution.allFinite())
    {
      return false;
    }
    this->Step = solution.head(this->Unknowns);
    this->NewMultipliers = solution.tail(this->Constraints);
    // A stretch that would leave its band goes as far as the bound, and the rest of the step
    // adapts.
    return this->holdLeaving() ? this->solve(exact) : true;
  }

  bool holdLeaving()
  {
    bool leaving = false;
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      const Index u = this->groupUnknown(k);
      const double bound = this->Problem.groups[k].tolerance;
      if (!this->Held[k] && std::abs(this->X[u] + this->Step[u]) > bound)
      {
        this->Held[k] = 1;
        this->HeldStep[static_cast<Index>(k)] = std::copysign(bound, this->Step[u]) - this->X[u];
        leaving = true;
      }
    }
    return leaving;
  }

  void holdAtBounds()
  {
    this->HeldStep.setZero();
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      this->Held[k] =
        std::abs(this->X[this->groupUnknown(k)]) >= this->Problem.groups[k].tolerance ? 1 : 0;
    }
  }

  /// Refined towards the system without the -delta block.
  Eigen::VectorXd solveKkt(const Eigen::VectorXd& rhs) const
  {
    Eigen::VectorXd x = this->Solver.solve(rhs);
    for (int refinement = 0; refinement < 2 && x.size() == rhs.size(); ++refinement)
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
    for (std::size_t k = 0; k < this->Held.size(); ++k)
    {
      double& h = x[this->groupUnknown(k)];
      h = std::clamp(h, -this->Problem.groups[k].tolerance, this->Problem.groups[k].tolerance);
    }
    return x;
  }

  double merit(const Eigen::VectorXd& x) const
  {
    return this->Model.objective(x, this->Run).total +
      this->Penalty * this->Model.constraints(x).lpNorm<1>();
  }

  Eigen::VectorXd corrected(const Eigen::VectorXd& x) const
  {
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(this->Unknowns + this->Constraints);
    rhs.tail(this->Constraints) = -this->Model.constraints(x);
    const Eigen::VectorXd correction = this->solveKkt(rhs);
    return correction.size() == rhs.size() && correction.allFinite()
      ? this->clipped(x + correction.head(this->Unknowns))
      : x;
  }

  bool advance(double& moved)
  {
    if (this->Run.cancelled())
    {
      return false;
    }
    const double violation = this->Point.constraints.lpNorm<1>();
    this->Penalty = std::max(this->Penalty, 1.2 * largest(this->NewMultipliers) + 1e-3);
    const double before = this->Terms.total + this->Penalty * violation;
    const double slope = this->Point.gradient.dot(this->Step) - this->Penalty * violation;
    // Below this a change of the merit function is rounding: that of the energy, and of lengths
    // between points as far from the origin as these.
    const double rounding = std::numeric_limits<double>::epsilon() * largest(this->X);
    const double noise = 1e-13 * (1.0 + std::abs(before)) +
      this->Penalty * rounding * static_cast<double>(this->Constraints);
    double scale = 1.0;
    for (int halving = 0; halving < 40; ++halving, scale *= 0.5)
    {
      const Eigen::VectorXd x = this->clipped(this->X + scale * this->Step);
      const double bound = before + 1e-4 * scale * std::min(slope, 0.0) + noise;
      if (this->merit(x) <= bound)
      {
        return this->accept(x, scale, moved);
      }
      if (halving == 0)
      {
        const Eigen::VectorXd second = this->corrected(x);
        if (this->merit(second) <= bound)
        {
          return this->accept(second, scale, moved);
        }
      }
    }
    return false;
  }

  bool accept(const Eigen::VectorXd& x, double scale, double& moved)
  {
    moved = largest(x - this->X);
    this->TookWholeStep = scale == 1.0 && this->Shift == 0.0;
    this->X = x;
    this->Multipliers += scale * (this->NewMultipliers - this->Multipliers);
    this->holdAtBounds();
    return true;
  }

  IsometricModel& Model;
  const AngleProblem& Problem;
  const IsometricOptions& Options;
  const Execution& Run;
  Index Unknowns;
  Index Constraints;
  std::vector<char> Held;   ///< stretches that are, or in this step go, to their bound
  Eigen::VectorXd HeldStep; ///< how far those go
  Eigen::VectorXd X;
  Eigen::VectorXd Multipliers;
  IsometricModel::Terms Terms;
  IsometricModel::Linearization Point;
  LinearSolver Solver{ Dissection() };
  bool UsedExact = false;
  double Shift = 0.0; ///< tau of the last factorization
  bool TookWholeStep = false;
  Eigen::VectorXd Step;
  Eigen::VectorXd NewMultipliers;
  double Penalty = 0.0;
};
}

IsometricSolution warpIsometrically(const Piece& piece, const AngleProblem& problem,
  const Points2& start, const std::vector<double>& startStretch, const IsometricOptions& options,
  const Execution& execution)
{
  if (execution.cancelled())
  {
    return cancelledSolution();
  }
  IsometricModel model(piece, problem, options.energy, options.angleWeight);
  IsometricSolution solution = IsometricIterations(model, problem, options, execution)
                                 .run(model.unknowns(start, startStretch));
  if (!solution.status.refused())
  {
    const WireNetwork& network = *problem.network;
    std::vector<double> length = problem.length;
    for (Index e = 0; e < network.edgeCount(); ++e)
    {
      const Index group = problem.stretchGroup[e];
      if (network.edges[e].connector)
      {
        length[e] =
          (solution.positions[network.edges[e].to] - solution.positions[network.edges[e].from])
            .norm();
      }
      else if (group != none)
      {
        length[e] *= 1.0 + solution.stretch[group];
      }
    }
    correctWireLengths(network, length, solution.positions);
  }
  return solution;
}
}
