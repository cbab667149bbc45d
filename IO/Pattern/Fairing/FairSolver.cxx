// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairSolver.h"

#include "Base/Types.h"
#include "Fairing/FairNetwork.h"
#include "Sparse/LinearSolver.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening::pattern
{
namespace
{
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Rows = Eigen::SparseMatrix<double>;

constexpr int steps = 60;
constexpr int patience = 6;           ///< steps that bring nothing
constexpr double exactLength = 1e-13; ///< of an interval, relative
constexpr double goodLength = 1e-10;
constexpr double goodStep = 1e-3; ///< what it may leave of what is missing
constexpr double sliding = 0.01;  ///< weight of what is missing along a curve, to that across it
constexpr double cornerWeight = 10.0;
constexpr double productsOfStep = 3000.0; ///< about, of an unknown
constexpr double softness = 1e-12;        ///< of constraints, which may depend on each other

class FairSolver
{
public:
  FairSolver(const FairNetwork& network, double wave)
    : Network(network)
    , Unknowns(static_cast<Eigen::Index>(network.nodes.size()))
  {
    for (const FairStretch& stretch : network.stretches)
    {
      this->Curves.emplace_back(stretch, this->Unknowns);
    }
    this->addObjective(std::pow(wave / (2.0 * pi), 4.0));
    if (network.held)
    {
      this->Linear.addHeld(network.nodes);
    }
    this->Linear.addHooksAndRings(this->Curves);
    this->Linear.addMirror(network, this->Curves);
    for (std::size_t s = 0; s < this->Curves.size(); ++s)
    {
      const FairStretch& stretch = network.stretches[s];
      double start = 0.0;
      double length = 0.0;
      for (const FairInterval& interval : stretch.intervals)
      {
        length += interval.length;
        // All parts of a segment have their share of it.
        if (!stretch.straight || &interval == &stretch.intervals.back())
        {
          if (!interval.follows)
          {
            this->Lengths.emplace_back(this->Curves[s], start, interval.end, length);
          }
          start = interval.end;
          length = 0.0;
        }
      }
    }
  }

  FairCurves solve()
  {
    FairCurves result;
    result.converged = this->factor() && this->iterate();
    if (!result.converged)
    {
      return result; // there may be no unknowns to read
    }
    for (std::size_t k = 0; k < this->Network.nodes.size(); ++k)
    {
      result.nodes.emplace_back(this->X.segment<2>(2 * static_cast<Eigen::Index>(k)));
    }
    for (const StretchCurve& curve : this->Curves)
    {
      result.spans.push_back(curve.spans(this->X));
      std::vector<double>& nearest = result.nearest.emplace_back();
      result.deviation.push_back(curve.deviation(this->Network.nodes, this->X, nearest));
    }
    return result;
  }

private:
  void addSquare(const Terms& terms, const Point2& target, const Eigen::Matrix2d& weight)
  {
    for (const Term& a : terms)
    {
      for (const Term& b : terms)
      {
        for (Eigen::Index d = 0; d < 2; ++d)
        {
          for (Eigen::Index e = 0; e < 2; ++e)
          {
            this->Entries.emplace_back(
              2 * a.unknown + d, 2 * b.unknown + e, weight(d, e) * a.factor * b.factor);
          }
        }
      }
      this->Right.segment<2>(2 * a.unknown) += a.factor * (weight * target);
    }
  }

  void addSquare(const Terms& terms, const Point2& target, double weight)
  {
    this->addSquare(terms, target, Eigen::Matrix2d(weight * Eigen::Matrix2d::Identity()));
  }

  /// Points may slide along the curve, but where others end on it.
  Eigen::Matrix2d weightOf(const FairStretch& stretch, std::size_t k) const
  {
    const Point2& before = k == 0 ? this->Network.nodes[stretch.from] : stretch.points[k - 1];
    const Point2& after =
      k + 1 == stretch.points.size() ? this->Network.nodes[stretch.to] : stretch.points[k + 1];
    const double start = k == 0 ? 0.0 : stretch.arc[k - 1];
    const double end = k + 1 == stretch.points.size() ? stretch.length() : stretch.arc[k + 1];
    const Point2 way = after - before;
    const double length = way.norm();
    const bool isHook = std::any_of(stretch.hooks.begin(), stretch.hooks.end(),
      [&](const FairHook& hook) { return hook.at == stretch.arc[k]; });
    const Point2 along = length > 0.0 && !isHook ? Point2(way / length) : Point2(Point2::Zero());
    return stretch.weights[k] * (end - start) / 2.0 *
      (Eigen::Matrix2d::Identity() - (1.0 - sliding) * along * along.transpose());
  }

  void addObjective(double bending)
  {
    this->Right = Vector::Zero(2 * this->Unknowns);
    std::vector<double> weightOfNode(this->Network.nodes.size(), 0.0);
    double total = 0.0;
    for (const StretchCurve& curve : this->Curves)
    {
      const FairStretch& stretch = curve.stretch();
      const double length = stretch.length();
      total += length;
      for (std::size_t k = 0; k < stretch.points.size(); ++k)
      {
        this->addSquare(curve.at(stretch.arc[k], Derivative::Place), stretch.points[k],
          this->weightOf(stretch, k));
      }
      const double first = stretch.points.empty() ? length / 2.0 : stretch.arc.front() / 2.0;
      const double last =
        stretch.points.empty() ? length / 2.0 : (length - stretch.arc.back()) / 2.0;
      // Corners are what the eye sees: they stay, as far as the lengths let them.
      const double end = stretch.smoothEnds ? 1.0 : cornerWeight;
      weightOfNode[stretch.from] += end * stretch.endWeights[0] * first;
      weightOfNode[stretch.to] += end * stretch.endWeights[1] * last;
      if (stretch.straight)
      {
        continue;
      }
      const std::vector<double>& breaks = curve.basis().breaks();
      for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
      {
        // Gauss's rule of two points: the second derivative is linear, its square quadratic.
        const double half = (breaks[k + 1] - breaks[k]) / 2.0;
        for (const double t : { -half / std::sqrt(3.0), half / std::sqrt(3.0) })
        {
          const Terms bend = curve.at(breaks[k] + half + t, Derivative::Bend);
          this->addSquare(bend, Point2::Zero(), bending * half);
        }
      }
    }
    for (std::size_t k = 0; k < weightOfNode.size(); ++k)
    {
      this->addSquare({ { static_cast<Eigen::Index>(k), 1.0 } }, this->Network.nodes[k],
        weightOfNode[k] + 1e-6 * total);
    }
    // A knot between two points that are far from each other is held by bending alone.
    for (Eigen::Index k = 0; k < 2 * this->Unknowns; ++k)
    {
      this->Entries.emplace_back(k, k, 1e-12 * total);
    }
  }

  bool factor()
  {
    this->Hessian.resize(2 * this->Unknowns, 2 * this->Unknowns);
    this->Hessian.setFromTriplets(this->Entries.begin(), this->Entries.end());
    this->Factor.compute(this->Hessian);
    this->Softness = softness / this->Hessian.diagonal().mean();
    return this->Factor.info() == Eigen::Success;
  }

  /// The step to the minimum of the objective under the constraints, as they are linearized.
  /// \param pull of the objective; zero: the shortest step to the constraints
  Vector stepOf(const Rows& rows, const Vector& pull, const Vector& missing)
  {
    const Eigen::Index unknowns = this->Hessian.rows();
    const Eigen::Index size = unknowns + rows.rows();
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&entries](const Rows& block, Eigen::Index row) {
      for (Eigen::Index column = 0; column < block.outerSize(); ++column)
      {
        for (Rows::InnerIterator entry(block, column); entry; ++entry)
        {
          entries.emplace_back(row + entry.row(), entry.col(), entry.value());
        }
      }
    };
    add(this->Hessian, 0);
    add(rows, unknowns);
    this->addTension(entries);
    for (Eigen::Index k = unknowns; k < size; ++k)
    {
      entries.emplace_back(k, k, -this->Softness);
    }
    Rows system(size, size);
    system.setFromTriplets(entries.begin(), entries.end());
    if (this->System.rows() != size)
    {
      this->System.analyzePattern(system);
    }
    this->System.factorize(system);
    if (this->System.info() == Eigen::Success)
    {
      Vector right(size);
      right << pull, missing;
      const Vector solution = this->System.solve(right);
      Vector change = solution.head(unknowns);
      this->Tensions = solution.tail(static_cast<Eigen::Index>(this->Lengths.size()));
      const double error = (rows * change - missing).lpNorm<Eigen::Infinity>();
      if (error <= goodStep * missing.lpNorm<Eigen::Infinity>() + exactLength * this->Longest)
      {
        return change;
      }
    }
    return this->leastStepOf(rows, pull, missing);
  }

  void addTension(std::vector<Eigen::Triplet<double>>& entries) const
  {
    for (std::size_t r = 0; r < this->Lengths.size(); ++r)
    {
      // Lengths that push would make the objective less than convex.
      this->Lengths[r].addTension(
        std::max(0.0, this->Tensions[static_cast<Eigen::Index>(r)]), this->X, entries);
    }
  }

  /// \return whether enough work was left
  bool spend(double products) const
  {
    return !this->Network.work || (*this->Network.work -= products) >= 0.0;
  }

  /// The same where rows depend on each other so much that softness cannot tell. Not finite where
  /// the work is used up.
  Vector leastStepOf(const Rows& rows, const Vector& pull, const Vector& missing) const
  {
    const auto size = static_cast<double>(rows.rows());
    if (!this->spend(size * size * static_cast<double>(rows.rows() + rows.cols())))
    {
      return Vector::Constant(rows.cols(), std::numeric_limits<double>::quiet_NaN());
    }
    const Vector free = this->Factor.solve(pull);
    const Matrix spread = this->Factor.solve(Matrix(rows.transpose()));
    return free + spread * leastNormSolution(rows * spread, missing - rows * free);
  }

  /// Rows of the constraints and what is missing to them.
  void constraints(Rows& rows, Vector& missing) const
  {
    const Eigen::Index linear = this->Linear.size();
    const auto lengths = static_cast<Eigen::Index>(this->Lengths.size());
    std::vector<Eigen::Triplet<double>> entries;
    missing = Vector::Zero(linear + lengths);
    this->Linear.add(this->X, entries, missing);
    for (Eigen::Index r = 0; r < lengths; ++r)
    {
      missing[linear + r] =
        this->Lengths[static_cast<std::size_t>(r)].addRow(linear + r, this->X, entries);
    }
    rows.resize(missing.size(), 2 * this->Unknowns);
    rows.setFromTriplets(entries.begin(), entries.end());
  }

  double largestMissing(const Vector& missing) const
  {
    double most = 0.0;
    // What lies below the last digits of coordinates cannot be made better.
    const double rounding =
      16.0 * std::numeric_limits<double>::epsilon() * this->X.lpNorm<Eigen::Infinity>();
    const Eigen::Index linear = this->Linear.size();
    for (Eigen::Index r = 0; r < missing.size(); ++r)
    {
      const double length =
        r < linear ? this->Longest : this->Lengths[static_cast<std::size_t>(r - linear)].wanted();
      most = std::max(most, (std::abs(missing[r]) - rounding) / length);
    }
    return most;
  }

  bool iterate()
  {
    this->X = this->Factor.solve(this->Right);
    for (const CurveLength& length : this->Lengths)
    {
      this->Longest = std::max(this->Longest, length.wanted());
    }
    const Vector free = this->X; // the minimum without constraints
    this->Tensions = Vector::Zero(static_cast<Eigen::Index>(this->Lengths.size()));
    double last = 1.0;
    double least = std::numeric_limits<double>::infinity();
    int stuck = 0;
    for (int step = 0; step < steps; ++step)
    {
      Rows rows;
      Vector missing;
      this->constraints(rows, missing);
      last = this->largestMissing(missing);
      stuck = step < steps / 3 || last < 0.5 * least ? 0 : stuck + 1;
      least = std::min(least, last);
      if (!missing.allFinite() || (stuck > patience && last > goodLength))
      {
        return false;
      }
      if (last < exactLength)
      {
        return true;
      }
      if (!this->spend(productsOfStep * static_cast<double>(missing.size() + this->X.size())))
      {
        return false;
      }
      // The first steps look for the minimum, the last ones for the lengths alone.
      const bool towardsMinimum = step < steps / 3;
      const Vector pull =
        towardsMinimum ? Vector(this->Hessian * (free - this->X)) : Vector(0.0 * this->X);
      Vector change = this->stepOf(rows, pull, missing);
      if (!change.allFinite())
      {
        return false;
      }
      const double most = change.lpNorm<Eigen::Infinity>();
      const double limit = 0.05 * this->Longest;
      if (most > limit)
      {
        change *= limit / most;
      }
      this->X += change;
      if (towardsMinimum && most < 1e-9 * this->Longest && last < 1e-11)
      {
        step = steps / 3; // it is there
      }
    }
    return last < goodLength;
  }

  const FairNetwork& Network;
  Eigen::Index Unknowns;
  std::vector<StretchCurve> Curves;
  std::vector<CurveLength> Lengths;
  LinearRows Linear;
  std::vector<Eigen::Triplet<double>> Entries;
  Vector Right;
  Rows Hessian;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> Factor;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> System; ///< with the constraints
  double Softness = 0.0;
  Vector X;
  Vector Tensions; ///< multipliers of the lengths
  double Longest = 0.0;
};
}

FairCurves solveFairNetwork(const FairNetwork& network, double wave)
{
  return FairSolver(network, wave).solve();
}
}
