// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/NewtonKktStep.h"

#include "Base/Types.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// Each gains about eight digits, 1 / regularization. What one leaves costs less to be taken out by
/// a step that follows.
constexpr int refinements = 2;
constexpr int refinementsBeforeChords = 1;
/// A factor that is kept in single precision is given up where a refinement leaves more of the
/// right-hand side than this. What the first solution leaves says little: it is rounding, in waves
/// as short as edges. On two million triangles that was 0.5, and 3e-6 once refined.
constexpr double singleIsEnough = 0.1;
/// Steps by the factor of another point are refined where a first solution leaves more: what the
/// other point leaves is larger than this.
constexpr double singleIsEnoughForChords = 2e-3;
/// Shifts tau of the Hessian: the smallest that matters beside entries about 1, growth by what
/// costs few factorizations and overshoots little, and a largest beside which the Hessian is
/// nothing.
constexpr double smallestShift = 1e-4;
constexpr double shiftGrowth = 4.0;
constexpr double largestShift = 1e12;
constexpr int maxShifts = 30;
/// The exact Hessian with more of a shift, or with a larger one, is no better than its convex part:
/// a wire that is pressed far beyond what makes it give way asks for a shift that holds the whole
/// sheet, and every step stays short.
constexpr int maxExactShifts = 4;
constexpr double largestExactShift = 1.0;
/// Beside which the Hessian, with entries about 1, does not count.
constexpr double shorteningShift = 100.0;
/// Of a direction that bends downwards most: each turns towards it by the ratio of curvatures.
constexpr int inverseIterations = 6;
/// Waves across the extent of the unknowns, in radians.
constexpr double waves = 17.0;
/// A step of which no more can be taken tells that the quadratic model ends nearer than the step: a
/// shift does what a trust region does.
constexpr double shortStep = 0.125;
/// Holds a bounded unknown on its way: what multipliers do to it, divided by this, is below the
/// rounding of its bound.
constexpr double activeStiffness = 1e20;
}

NewtonKktStep::NewtonKktStep(NewtonKktModel& model, LinearSolver solver, const Execution& execution)
  : Model(model)
  , Solver(std::move(solver))
  , Run(execution)
  , Bounds(model.bounds())
  , Unknowns(model.unknownCount())
  , Constraints(model.constraintCount())
  , FirstBounded(Unknowns - static_cast<Index>(Bounds.size()))
  , Active(Bounds.size(), 0)
  , ActiveStep(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(Bounds.size())))
{
}

bool NewtonKktStep::cancelled()
{
  this->Stopped = this->Stopped || this->Run.cancelled();
  return this->Stopped;
}

void NewtonKktStep::linearize(
  const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, Curvature curvature)
{
  this->X = x;
  this->OldMultipliers = multipliers;
  this->Point = this->Model.linearize(this->X, this->OldMultipliers, curvature,
    this->InversePenalty > 0.0 ? this->InversePenalty : regularization, this->Run);
  this->Hessian = curvature;
  this->Chord = false;
  this->HasUnshiftedFactor = false;
  this->Shift = 0.0;
  this->ActiveStep.setZero();
  if (!this->Active.empty())
  {
    this->findActiveSet();
  }
}

bool NewtonKktStep::linearizeForChord(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers)
{
  const bool free =
    std::none_of(this->Active.begin(), this->Active.end(), [](char held) { return held != 0; });
  if (!this->HasUnshiftedFactor || !free)
  {
    return false;
  }
  if (this->Chord && this->X == x)
  {
    this->OldMultipliers = multipliers;
    return true;
  }
  std::optional<NewtonKktModel::Linearization> point = this->Model.differentiate(x, this->Run);
  if (!point)
  {
    return false;
  }
  this->X = x;
  this->OldMultipliers = multipliers;
  this->Point = std::move(*point);
  this->Chord = true;
  return true;
}

Eigen::VectorXd NewtonKktStep::lagrangianGradient(const Eigen::VectorXd& multipliers) const
{
  return this->Point.gradient + this->Model.transposedJacobianTimes(multipliers);
}

/// Holds the unknowns on a bound that are drawn outwards.
void NewtonKktStep::findActiveSet()
{
  const Eigen::VectorXd g = this->lagrangianGradient(this->OldMultipliers);
  for (std::size_t k = 0; k < this->Active.size(); ++k)
  {
    const Index u = this->unknownOf(k);
    const double x = this->X[u];
    this->Active[k] = std::abs(x) >= this->Bounds[k] && g[u] * x <= 0.0 ? 1 : 0;
    if (this->Active[k])
    {
      this->Model.stiffen(static_cast<Index>(k), activeStiffness);
    }
  }
}

double NewtonKktStep::optimality(const Eigen::VectorXd& multipliers) const
{
  Eigen::VectorXd g = this->lagrangianGradient(multipliers);
  for (std::size_t k = 0; k < this->Active.size(); ++k)
  {
    if (this->Active[k])
    {
      g[this->unknownOf(k)] = 0.0;
    }
  }
  return largest(g);
}

double NewtonKktStep::predictedReduction() const
{
  return 0.5 * std::abs(this->Point.gradient.dot(this->Step));
}

bool NewtonKktStep::shouldLeaveActiveSet() const
{
  const Eigen::VectorXd g = this->lagrangianGradient(this->Multipliers);
  for (std::size_t k = 0; k < this->Active.size(); ++k)
  {
    const Index u = this->unknownOf(k);
    if (this->Active[k] && g[u] * (this->X[u] + this->ActiveStep[Eigen::Index(k)]) > 0.0)
    {
      return true;
    }
  }
  return false;
}

bool NewtonKktStep::tryFactorize()
{
  ++this->Factorizations;
  bool factored = !this->cancelled() && this->Solver.factorize(this->Model.kkt(), this->Run);
  if (!factored && this->Solver.precision() == FactorPrecision::Single && !this->cancelled())
  {
    this->Solver.keepDouble(); // which holds larger numbers
    factored = this->Solver.factorize(this->Model.kkt(), this->Run);
  }
  return factored && this->Solver.positive() == this->Unknowns;
}

/// Adds a growing multiple of the identity to the Hessian, at most this often and this much.
bool NewtonKktStep::shiftUntilConvex(double tau, int most, double largest)
{
  bool done = false;
  for (int k = 0; !done && k < most && tau <= largest && !this->cancelled();
       ++k, tau *= shiftGrowth)
  {
    this->Model.shift(tau - this->Shift);
    this->Shift = tau;
    done = this->tryFactorize();
  }
  return done;
}

/// Factors the KKT matrix with a Hessian that is convex on the constraints' tangent space.
bool NewtonKktStep::factorize()
{
  const auto damped = [this] {
    if (this->Shift < this->Damping)
    {
      this->Model.shift(this->Damping - this->Shift);
      this->Shift = this->Damping;
    }
    return this->tryFactorize();
  };
  const auto from = [this](double last) {
    return this->Shift > 0.0 ? shiftGrowth * this->Shift
                             : std::max(smallestShift, last / shiftGrowth);
  };
  bool done = damped();
  this->Indefinite = false;
  if (this->Hessian == Curvature::Exact && this->Model.hasConvexPart())
  {
    this->Indefinite = !done;
    done = done ||
      (this->HandlesSaddles &&
        this->shiftUntilConvex(from(this->ExactShift), maxExactShifts, largestExactShift));
    this->ExactShift = done ? this->Shift : shiftGrowth * largestExactShift; // then try once
    if (!done)
    {
      this->linearize(this->X, this->OldMultipliers, Curvature::Convex);
      done = damped();
    }
  }
  done = done || this->shiftUntilConvex(from(this->LastShift), maxShifts, largestShift);
  this->LastShift = this->Shift;
  return done;
}

Eigen::VectorXd NewtonKktStep::negativeCurvatureDirection()
{
  this->linearize(this->X, this->OldMultipliers, Curvature::Exact);
  if (this->tryFactorize() || !this->shiftUntilConvex(smallestShift, maxShifts, largestShift))
  {
    return {};
  }
  // Inverse iteration, from waves that no symmetry of the point shares.
  const double extent = std::max(this->X.cwiseAbs().maxCoeff(), 1e-300);
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(this->Unknowns + this->Constraints);
  for (Index k = 0; k < this->Unknowns; ++k)
  {
    const double beside = this->X[std::min(k ^ 1, this->Unknowns - 1)];
    rhs[k] = std::sin(waves * (this->X[k] + 0.6 * beside) / extent + (k & 1));
  }
  for (int k = 0; k < inverseIterations; ++k)
  {
    const Eigen::MatrixXd solution = this->Solver.solve(rhs, this->Run);
    if (solution.rows() != rhs.size())
    {
      return {};
    }
    rhs.head(this->Unknowns) = solution.col(0).head(this->Unknowns) /
      solution.col(0).head(this->Unknowns).cwiseAbs().maxCoeff();
    rhs.tail(this->Constraints).setZero();
  }
  return rhs.head(this->Unknowns);
}

void NewtonKktStep::updateDamping(double fraction)
{
  if (!this->HandlesSaddles)
  {
    return;
  }
  if (fraction <= shortStep)
  {
    this->Damping = std::max(smallestShift, shiftGrowth * this->Damping);
  }
  else if (fraction == 1.0)
  {
    this->Damping = this->Damping > smallestShift ? this->Damping / shiftGrowth : 0.0;
  }
}

bool NewtonKktStep::solve()
{
  if (this->Chord)
  {
    return this->solveChord();
  }
  bool found = this->factorize() && this->solveActive();
  // An unknown that would leave its bounds goes to the bound, and the rest of the step adapts.
  while (found && this->growActiveSet())
  {
    found = this->factorize() && this->solveActive();
  }
  return found;
}

/// The same step by the change of the multipliers, whose Jacobian is that of this point.
bool NewtonKktStep::solveChord()
{
  Eigen::VectorXd rhs(this->Unknowns + this->Constraints);
  rhs.head(this->Unknowns) = -this->lagrangianGradient(this->OldMultipliers);
  rhs.tail(this->Constraints) = -this->Point.constraints;
  Eigen::VectorXd solution = this->Solver.solve(rhs, this->Run);
  if (this->FirstResidual > singleIsEnoughForChords && solution.size() == rhs.size())
  {
    const Eigen::VectorXd r = rhs - this->Model.kkt().selfadjointView<Eigen::Lower>() * solution;
    const Eigen::VectorXd change = this->Solver.solve(r, this->Run);
    solution += change.size() == rhs.size() ? change : Eigen::VectorXd::Zero(rhs.size());
  }
  if (!this->splitSolution(solution))
  {
    return false;
  }
  this->Multipliers += this->OldMultipliers;
  for (std::size_t k = 0; k < this->Bounds.size(); ++k)
  {
    const Index u = this->unknownOf(k);
    if (std::abs(this->X[u] + this->Step[u]) > this->Bounds[k])
    {
      return false;
    }
  }
  return true;
}

bool NewtonKktStep::solveActive()
{
  // A factor in single precision leaves a fraction of the right-hand side, so that has to vanish at
  // a minimum: then the change of the multipliers is asked for.
  const bool changes = this->Solver.precision() == FactorPrecision::Single;
  Eigen::VectorXd rhs(this->Unknowns + this->Constraints);
  rhs.head(this->Unknowns) =
    changes ? -this->lagrangianGradient(this->OldMultipliers) : -this->Point.gradient;
  rhs.tail(this->Constraints) = -this->Point.constraints;
  for (std::size_t k = 0; k < this->Active.size(); ++k)
  {
    if (this->Active[k])
    {
      rhs[this->unknownOf(k)] = activeStiffness * this->ActiveStep[static_cast<Eigen::Index>(k)];
    }
  }
  KktSolution solution = this->solveKkt(rhs);
  if (this->Solver.precision() == FactorPrecision::Single &&
    !(solution.refinedResidual <= singleIsEnough))
  {
    this->Solver.keepDouble();
    if (!this->tryFactorize())
    {
      return false;
    }
    solution = this->solveKkt(rhs);
  }
  this->FirstResidual = solution.firstResidual;
  // The multiplier part of the solution is the new multiplier itself, or its change.
  if (!this->splitSolution(solution.x))
  {
    return false;
  }
  if (changes)
  {
    this->Multipliers += this->OldMultipliers;
  }
  this->HasUnshiftedFactor = this->Shift == 0.0;
  return true;
}

bool NewtonKktStep::splitSolution(const Eigen::VectorXd& solution)
{
  if (solution.size() != this->Unknowns + this->Constraints || !isFinite(solution))
  {
    return false;
  }
  this->Step = solution.head(this->Unknowns);
  this->Multipliers = solution.tail(this->Constraints);
  return true;
}

bool NewtonKktStep::growActiveSet()
{
  bool leaving = false;
  for (std::size_t k = 0; k < this->Active.size(); ++k)
  {
    const Index u = this->unknownOf(k);
    if (!this->Active[k] && std::abs(this->X[u] + this->Step[u]) > this->Bounds[k])
    {
      this->Active[k] = 1;
      this->ActiveStep[static_cast<Eigen::Index>(k)] =
        std::copysign(this->Bounds[k], this->Step[u]) - this->X[u];
      this->Model.stiffen(static_cast<Index>(k), activeStiffness);
      leaving = true;
    }
  }
  return leaving;
}

/// Refined towards the system without the -delta block.
NewtonKktStep::KktSolution NewtonKktStep::solveKkt(const Eigen::VectorXd& rhs) const
{
  KktSolution solution{ this->Solver.solve(rhs, this->Run), 0.0, 0.0 };
  Eigen::VectorXd& x = solution.x;
  if (x.size() != rhs.size())
  {
    solution.refinedResidual = std::numeric_limits<double>::infinity();
    return solution;
  }
  const auto residual = [&] {
    Eigen::VectorXd r = rhs - this->Model.kkt().selfadjointView<Eigen::Lower>() * x;
    r.tail(this->Constraints) -= regularization * x.tail(this->Constraints);
    return r;
  };
  const auto share = [&rhs](const Eigen::VectorXd& r) {
    return r.cwiseAbs().maxCoeff() /
      std::max(rhs.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  };
  const int wanted = this->ChordSteps ? refinementsBeforeChords : refinements;
  const int most = this->InversePenalty > 0.0 ? 0 : wanted;
  for (int refinement = 0; refinement < most; ++refinement)
  {
    const Eigen::VectorXd r = residual();
    solution.firstResidual = refinement == 0 ? share(r) : solution.firstResidual;
    const Eigen::MatrixXd change = this->Solver.solve(r, this->Run);
    if (change.rows() != x.size())
    {
      break;
    }
    x += change;
  }
  const bool doubtful = !(solution.firstResidual <= singleIsEnough);
  solution.refinedResidual = doubtful ? share(residual()) : solution.firstResidual;
  return solution;
}

bool NewtonKktStep::shortenCorrections()
{
  this->HasUnshiftedFactor = false;
  this->Model.shift(shorteningShift - this->Shift);
  return this->tryFactorize();
}

Eigen::VectorXd NewtonKktStep::clipped(Eigen::VectorXd x) const
{
  for (std::size_t k = 0; k < this->Bounds.size(); ++k)
  {
    double& value = x[this->unknownOf(k)];
    value = std::clamp(value, -this->Bounds[k], this->Bounds[k]);
  }
  return x;
}

Eigen::VectorXd NewtonKktStep::corrected(const Eigen::VectorXd& x) const
{
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(this->Unknowns + this->Constraints);
  rhs.tail(this->Constraints) = -this->Model.constraints(x);
  const Eigen::VectorXd correction = this->solveKkt(rhs).x;
  return correction.size() == rhs.size() && isFinite(correction)
    ? this->clipped(x + correction.head(this->Unknowns))
    : x;
}
}
