// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/RigidEmbedding.h"

#include "Sparse/NewtonKktStep.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
/// The linear map of a triangle, w -> alpha w + beta conj(w).
struct PlanarMap
{
  Complex alpha;
  Complex beta;
};

namespace
{
/// An energy below this fraction of the area is zero up to rounding.
constexpr double nothing = 1e-26;
constexpr int maximumConjugateGradients = 100;
/// Conjugate gradients stop when one lowers the model by less than this fraction of what all did;
/// three or four get there. A coarser value saves one of them and costs the next Newton step
/// digits.
constexpr double modelAccuracy = 1e-3;
/// The Hessian's inverse is taken to be at most this many times the preconditioner's; that three or
/// four conjugate gradients are enough says that it is less.
constexpr double conditionBound = 10.0;

/// The operators of std::complex look for infinities; these do not.
Complex times(const Complex& a, const Complex& b)
{
  return { a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real() };
}
Complex timesConj(const Complex& a, const Complex& b)
{
  return { a.real() * b.real() + a.imag() * b.imag(), a.imag() * b.real() - a.real() * b.imag() };
}

double dot(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return a.cwiseProduct(b).sum();
}

/// The map that takes a triangle to these places of its corners.
PlanarMap mapOf(const Triangle& c, const TriangleFrame& frame, const Eigen::MatrixXd& places)
{
  const auto& g = frame.gradient;
  const Complex u1(places(c[1], 0) - places(c[0], 0), places(c[1], 1) - places(c[0], 1));
  const Complex u2(places(c[2], 0) - places(c[0], 0), places(c[2], 1) - places(c[0], 1));
  return { timesConj(u1, g[1]) + timesConj(u2, g[2]), times(u1, g[1]) + times(u2, g[2]) };
}

/// Adds to each corner what a derivative by the triangle's map is by that corner.
void addByCorners(
  const Triangle& c, const TriangleFrame& frame, const PlanarMap& byMap, Eigen::MatrixXd& sum)
{
  for (int k = 0; k < 3; ++k)
  {
    const Complex part =
      times(byMap.alpha, frame.gradient[k]) + timesConj(byMap.beta, frame.gradient[k]);
    sum(c[k], 0) += part.real();
    sum(c[k], 1) += part.imag();
  }
}
}

/// What the energy's derivatives need of a triangle.
struct RigidEmbedding::Linearized
{
  PlanarMap map;
  Complex rotation;   ///< alpha / |alpha|
  double slack = 0.0; ///< 1 / |alpha|
};

RigidEmbedding::RigidEmbedding(InteriorSystem& system, const LinearSolver* preconditioner,
  const Eigen::MatrixXd& positions, const Execution& execution)
  : Patch(&system.patch())
  , Frames(&system.frames())
  , Preconditioner(preconditioner)
  , Run(execution)
  , Positions(positions)
{
  for (const TriangleFrame& frame : *this->Frames)
  {
    this->Area += frame.area;
  }
}

LargeArray<RigidEmbedding::Linearized> RigidEmbedding::linearize() const
{
  LargeArray<Linearized> state(this->Frames->size());
  for (std::size_t t = 0; t < this->Frames->size(); ++t)
  {
    Linearized& s = state[t];
    s.map = mapOf(this->Patch->triangles[t], (*this->Frames)[t], this->Positions);
    const double size = std::sqrt(std::norm(s.map.alpha));
    s.rotation = size > 0.0 ? s.map.alpha / size : Complex(1.0, 0.0);
    s.slack = 1.0 / std::max(size, 1e-8);
  }
  return state;
}

double RigidEmbedding::energy(const Eigen::MatrixXd& positions) const
{
  double sum = 0.0;
  for (std::size_t t = 0; t < this->Frames->size(); ++t)
  {
    const PlanarMap map = mapOf(this->Patch->triangles[t], (*this->Frames)[t], positions);
    const double size = std::sqrt(std::norm(map.alpha));
    sum += (*this->Frames)[t].area * ((size - 1.0) * (size - 1.0) + std::norm(map.beta));
  }
  return sum;
}

Eigen::MatrixXd RigidEmbedding::gradient(const LargeArray<Linearized>& state) const
{
  Eigen::MatrixXd sum =
    Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(this->Patch->vertices.size()), 2);
  for (std::size_t t = 0; t < this->Frames->size(); ++t)
  {
    const TriangleFrame& frame = (*this->Frames)[t];
    addByCorners(this->Patch->triangles[t], frame,
      { 2.0 * frame.area * (state[t].map.alpha - state[t].rotation),
        2.0 * frame.area * state[t].map.beta },
      sum);
  }
  return sum.topRows(this->Patch->freeCount);
}

Eigen::MatrixXd RigidEmbedding::curvature(
  const LargeArray<Linearized>& state, const Eigen::MatrixXd& direction) const
{
  const auto all = static_cast<Eigen::Index>(this->Patch->vertices.size());
  Eigen::MatrixXd along = Eigen::MatrixXd::Zero(all, 2);
  along.topRows(this->Patch->freeCount) = direction;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(all, 2);
  for (std::size_t t = 0; t < this->Frames->size(); ++t)
  {
    const Triangle& c = this->Patch->triangles[t];
    const TriangleFrame& frame = (*this->Frames)[t];
    PlanarMap change = mapOf(c, frame, along);
    // Turning alpha costs less than stretching it, by 1 / |alpha|.
    const double turn = timesConj(change.alpha, state[t].rotation).imag() * state[t].slack;
    change.alpha -= Complex(-turn * state[t].rotation.imag(), turn * state[t].rotation.real());
    change.alpha *= 2.0 * frame.area;
    change.beta *= 2.0 * frame.area;
    addByCorners(c, frame, change, sum);
  }
  return sum.topRows(this->Patch->freeCount);
}

RigidEmbedding::Direction RigidEmbedding::newtonDirection(
  const LargeArray<Linearized>& state, const Eigen::MatrixXd& descent, double enough) const
{
  Eigen::MatrixXd step = Eigen::MatrixXd::Zero(descent.rows(), 2);
  Eigen::MatrixXd residual = descent;
  Eigen::MatrixXd preconditioned = this->Preconditioner->solve(residual, this->Run);
  Eigen::MatrixXd direction = preconditioned;
  double product = dot(residual, preconditioned);
  if (0.5 * conditionBound * product <= enough)
  {
    return { preconditioned, true };
  }
  double modelDecrease = 0.0;
  for (int iteration = 0; iteration < maximumConjugateGradients; ++iteration)
  {
    const Eigen::MatrixXd bent = this->curvature(state, direction);
    const double curvatureAlong = dot(direction, bent);
    if (!(curvatureAlong > 0.0))
    {
      return { iteration == 0 ? direction : step, false };
    }
    const double length = product / curvatureAlong;
    step += length * direction;
    // The model falls by this much; when that is little beside what it fell before, enough is done
    // (S. G. Nash, A. Sofer, "Assessing a search direction within a truncated-Newton method",
    // Operations Research Letters 9(4), 1990).
    const double fall = 0.5 * length * product;
    modelDecrease += fall;
    if (fall <= modelAccuracy * modelDecrease)
    {
      break;
    }
    residual -= length * bent;
    preconditioned = this->Preconditioner->solve(residual, this->Run);
    const double next = dot(residual, preconditioned);
    direction = preconditioned + (next / product) * direction;
    product = next;
  }
  return { step, false };
}

RigidEmbedding::State RigidEmbedding::iterate(double energyTolerance)
{
  const LargeArray<Linearized> state = this->linearize();
  const double before = this->energy(this->Positions);
  if (before <= nothing * this->Area)
  {
    return State::Converged;
  }
  const Eigen::MatrixXd descent = -this->gradient(state);
  const auto [step, last] = this->newtonDirection(state, descent, energyTolerance * before);
  const double slope = dot(descent, step);
  if (!(slope > 0.0))
  {
    return slope == 0.0 ? State::Converged : State::Failed;
  }
  const Index free = this->Patch->freeCount;
  Eigen::MatrixXd trial = this->Positions;
  double scale = 1.0;
  for (int halving = 0; halving < maximumHalvings; ++halving, scale *= 0.5)
  {
    trial.topRows(free) = this->Positions.topRows(free) + scale * step;
    const double after = this->energy(trial);
    if (after <= before - sufficientDecrease * scale * slope)
    {
      this->Positions.swap(trial);
      const bool small = last || before - after <= energyTolerance * before;
      return small || after <= nothing * this->Area ? State::Converged : State::Running;
    }
    if (scale * slope <= 1e-12 * before)
    {
      return State::Converged; // up to the rounding of the energy
    }
  }
  return State::Failed;
}
}
