// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairNetwork.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace flattening::pattern
{
bool FairStretch::isHook(std::size_t point) const
{
  return std::any_of(this->hooks.begin(), this->hooks.end(),
    [&](const FairHook& hook) { return hook.at == this->arc[point]; });
}

namespace
{
using Vector = Eigen::VectorXd;
using Rows = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

/// A place on a curve, or a derivative there: a linear combination of four unknown points.
struct Terms
{
  std::array<Eigen::Index, 4> unknown{};
  Eigen::Vector4d factor = Eigen::Vector4d::Zero();

  Point2 sum(const Vector& x) const
  {
    Point2 result = Point2::Zero();
    for (std::size_t k = 0; k < 4; ++k)
    {
      result += this->factor[static_cast<Eigen::Index>(k)] * x.segment<2>(2 * this->unknown[k]);
    }
    return result;
  }
};

enum class Derivative
{
  Place,
  Slope,
  Bend,
};

/// Derivative of Bernstein's polynomials by a parameter u / width, u from 0 to 1.
Eigen::Vector4d bernstein(double u, double width, Derivative derivative)
{
  const double v = 1.0 - u;
  switch (derivative)
  {
    case Derivative::Place:
      return { v * v * v, 3.0 * u * v * v, 3.0 * u * u * v, u * u * u };
    case Derivative::Slope:
      return 3.0 / width * Eigen::Vector4d(-v * v, v * v - 2.0 * u * v, 2.0 * u * v - u * u, u * u);
    default:
      return 6.0 / (width * width) * Eigen::Vector4d(v, u - 2.0 * v, v - 2.0 * u, u);
  }
}

/// A stretch as a curve of unknown points: its nodes, and between them the two inner control points
/// of each span. The ends of a span within follow, such that the curve is differentiable there.
class StretchCurve
{
public:
  /// The stretch stays the caller's.
  /// \param next the first unknown that is free; those taken are counted
  StretchCurve(const FairStretch& stretch, Eigen::Index& next)
    : Stretch(stretch)
    , First(next)
  {
    next += stretch.straight ? 0 : static_cast<Eigen::Index>(2 * this->spanCount());
  }

  const FairStretch& stretch() const { return this->Stretch; }

  /// The unknown points that it depends on, from its first node to its last.
  std::vector<Eigen::Index> unknowns() const
  {
    std::vector<Eigen::Index> unknowns;
    for (std::size_t j = 0; j < 2 * this->spanCount() + 2; ++j)
    {
      const bool end = j == 0 || j == 2 * this->spanCount() + 1;
      if (end || !this->Stretch.straight)
      {
        unknowns.push_back(this->unknown(j));
      }
    }
    return unknowns;
  }

  /// Of the span at a place; what is straight is one.
  double widthAt(double t) const
  {
    return this->Stretch.straight ? this->Stretch.length() : this->width(this->spanAt(t));
  }

  Terms at(double t, Derivative derivative) const
  {
    Terms terms;
    if (this->Stretch.straight)
    {
      const double length = this->Stretch.length();
      const double share = derivative == Derivative::Place ? t / length
        : derivative == Derivative::Slope                  ? 1.0 / length
                                                           : 0.0;
      const Eigen::Index from = this->unknown(0);
      const Eigen::Index to = this->unknown(2 * this->spanCount() + 1);
      terms.unknown = { from, to, from, to };
      terms.factor[0] = (derivative == Derivative::Place ? 1.0 : 0.0) - share;
      terms.factor[1] = share;
      return terms;
    }
    const std::size_t span = this->spanAt(t);
    const double width = this->width(span);
    const double start = span > 0 ? width / (this->width(span - 1) + width) : 1.0;
    const double end = span + 1 < this->spanCount() ? width / (width + this->width(span + 1)) : 1.0;
    const Eigen::Vector4d b =
      bernstein((t - this->Stretch.breaks[span]) / width, width, derivative);
    terms.factor = { start * b[0], (1.0 - start) * b[0] + b[1], b[2] + (1.0 - end) * b[3],
      end * b[3] };
    for (std::size_t k = 0; k < 4; ++k)
    {
      terms.unknown[k] = this->unknown(2 * span + k);
    }
    return terms;
  }

  std::vector<FairSpan> spans(const Vector& x) const
  {
    std::vector<FairSpan> spans;
    for (std::size_t k = 0; k < this->spanCount(); ++k)
    {
      const double from = this->Stretch.breaks[k];
      const double to = this->Stretch.breaks[k + 1];
      const double third = (to - from) / 3.0;
      // The curve is differentiable, so that the side of a break does not matter.
      const Point2 start = this->at(from, Derivative::Place).sum(x);
      const Point2 end = this->at(to, Derivative::Place).sum(x);
      spans.push_back({ from, to,
        { start, start + third * this->at(from, Derivative::Slope).sum(x),
          end - third * this->at(to, Derivative::Slope).sum(x), end } });
    }
    return spans;
  }

  /// How far points are across the curve, along which they may slide, between those of its ends.
  std::vector<double> deviation(const Vector& x, std::vector<double>& nearest) const
  {
    const FairStretch& stretch = this->Stretch;
    std::vector<double> deviation;
    for (std::size_t k = 0; k < stretch.points.size(); ++k)
    {
      double t = stretch.arc[k];
      if (k == 0 || k + 1 == stretch.points.size())
      {
        deviation.push_back((stretch.points[k] - this->at(t, Derivative::Place).sum(x)).norm());
        nearest.push_back(t);
        continue;
      }
      Point2 slope;
      Point2 off;
      for (int step = 0; step < 4; ++step)
      {
        slope = this->at(t, Derivative::Slope).sum(x);
        off = stretch.points[k] - this->at(t, Derivative::Place).sum(x);
        t = std::clamp(
          t + slope.dot(off) / std::max(slope.squaredNorm(), 1e-24), 0.0, stretch.length());
      }
      deviation.push_back(std::abs(cross(slope, off)) / std::max(slope.norm(), 1e-12));
      nearest.push_back(t);
    }
    return deviation;
  }

private:
  std::size_t spanCount() const { return this->Stretch.breaks.size() - 1; }
  std::size_t spanAt(double t) const
  {
    const std::vector<double>& breaks = this->Stretch.breaks;
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, t);
    return static_cast<std::size_t>(above - breaks.begin()) - 1;
  }
  double width(std::size_t span) const
  {
    return this->Stretch.breaks[span + 1] - this->Stretch.breaks[span];
  }
  Eigen::Index unknown(std::size_t j) const
  {
    return j == 0                      ? static_cast<Eigen::Index>(this->Stretch.from)
      : j == 2 * this->spanCount() + 1 ? static_cast<Eigen::Index>(this->Stretch.to)
                                       : this->First + static_cast<Eigen::Index>(j) - 1;
  }

  const FairStretch& Stretch;
  Eigen::Index First = 0;
};

/// The condition that a part of a curve has a length, with its derivatives by the unknowns.
class CurveLength
{
public:
  /// \param from along the stretch \param to where the part ends \param wanted its length
  CurveLength(const StretchCurve& curve, double from, double to, double wanted)
    : Wanted(wanted)
  {
    const auto add = [&](double end) {
      Part& part = this->Parts.emplace_back();
      const double share = (end - from) / curve.widthAt(0.5 * (from + end));
      const int parts = std::clamp(static_cast<int>(std::ceil(spanParts * share)), 1, spanParts);
      integrate(from, end, parts, [&](double t, double weight) {
        const Terms slope = curve.at(t, Derivative::Slope);
        part.weights.push_back(weight);
        part.slopes.push_back(slope.factor);
        part.unknown = part.weights.size() == 1 ? slope.unknown : part.unknown;
      });
      from = end;
    };
    const std::vector<double>& breaks = curve.stretch().breaks;
    for (auto at = std::upper_bound(breaks.begin(), breaks.end(), from);
         at != breaks.end() && *at < to; ++at)
    {
      add(*at);
    }
    add(to);
  }

  double wanted() const { return this->Wanted; }

  /// Adds its derivative as a row, and to other entries its second derivative times a tension:
  /// there are the same of these whatever that is. \return what is missing to the length
  double add(
    Eigen::Index row, double tension, const Vector& x, Entries& slopes, Entries& bends) const
  {
    double missing = this->Wanted;
    for (const Part& part : this->Parts)
    {
      Terms slope;
      slope.unknown = part.unknown;
      Eigen::Matrix<double, 2, 4> first = Eigen::Matrix<double, 2, 4>::Zero();
      Eigen::Matrix<double, 8, 8> second = Eigen::Matrix<double, 8, 8>::Zero();
      for (std::size_t place = 0; place < part.weights.size(); ++place)
      {
        slope.factor = part.slopes[place];
        const Point2 way = slope.sum(x);
        const double speed = way.norm();
        if (!(speed > 0.0))
        {
          continue;
        }
        const Point2 unit = way / speed;
        const double weight = part.weights[place];
        missing -= weight * speed;
        first += weight * unit * slope.factor.transpose();
        if (tension != 0.0)
        {
          Eigen::Matrix<double, 8, 1> across;
          Eigen::Map<Eigen::Matrix<double, 2, 4>>(across.data()) =
            Point2(-unit.y(), unit.x()) * slope.factor.transpose();
          second.noalias() += (tension * weight / speed) * across * across.transpose();
        }
      }
      const auto coordinate = [&part](Eigen::Index k) {
        return 2 * part.unknown[static_cast<std::size_t>(k / 2)] + k % 2;
      };
      // Parts of one span that follow each other share their entries.
      const std::size_t block = bends.size() < 64 ? 0 : bends.size() - 64;
      const bool shared = bends.size() > block && bends[block].row() == coordinate(0) &&
        bends.back().row() == coordinate(7);
      for (Eigen::Index a = 0; a < 8; ++a)
      {
        slopes.emplace_back(row, coordinate(a), first(a % 2, a / 2));
        for (Eigen::Index b = 0; b < 8; ++b)
        {
          if (shared)
          {
            Eigen::Triplet<double>& entry = bends[block + static_cast<std::size_t>(8 * a + b)];
            entry = { entry.row(), entry.col(), entry.value() + second(a, b) };
          }
          else
          {
            bends.emplace_back(coordinate(a), coordinate(b), second(a, b));
          }
        }
      }
    }
    return missing;
  }

private:
  /// What lies in one span of the curve, so that all its places have the same unknowns.
  struct Part
  {
    std::array<Eigen::Index, 4> unknown{};
    std::vector<Eigen::Vector4d> slopes; ///< at the places of its integral
    std::vector<double> weights;
  };

  double Wanted;
  std::vector<Part> Parts;
};

Terms nodeTerms(std::size_t node)
{
  Terms terms;
  terms.unknown.fill(static_cast<Eigen::Index>(node));
  terms.factor[0] = 1.0;
  return terms;
}

constexpr int steps = 60;
constexpr int patience = 6;           ///< steps that bring nothing
constexpr double exactLength = 1e-13; ///< of an interval, relative
constexpr double goodLength = 1e-10;
constexpr double sliding = 0.01; ///< weight of what is missing along a curve, to that across it
constexpr double cornerWeight = 10.0;
/// Of a step to the minimum, relative: the next one would be about its square.
constexpr double goodStep = 1e-6;
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Of constraints, which may depend on each other. Pivots are not chosen by size: with smaller ones
/// on the diagonal a step loses its digits.
constexpr double softness = 1e-8;
constexpr int refinements = 2; ///< of a step, since its factors have rounding errors

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
    for (std::size_t k = 0; network.held && k < network.nodes.size(); ++k)
    {
      for (const Eigen::Index d : { 0, 1 })
      {
        this->addRow({ { 2 * static_cast<Eigen::Index>(k) + d, 1.0 } }, network.nodes[k][d]);
      }
    }
    for (const StretchCurve& curve : this->Curves)
    {
      for (const FairHook& hook : curve.stretch().hooks)
      {
        this->addSame(curve.at(hook.at, Derivative::Place), nodeTerms(hook.node));
      }
      if (curve.stretch().smoothEnds)
      {
        this->addSame(
          curve.at(0.0, Derivative::Slope), curve.at(curve.stretch().length(), Derivative::Slope));
      }
      this->addLengths(curve);
    }
    this->addMirror();
  }

  FairCurves solve()
  {
    FairCurves result;
    result.converged = this->iterate();
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
      result.deviation.push_back(curve.deviation(this->X, result.nearest.emplace_back()));
    }
    return result;
  }

private:
  void addRow(const std::vector<std::pair<Eigen::Index, double>>& factors, double value)
  {
    for (const auto& [coordinate, factor] : factors)
    {
      this->Linear.emplace_back(static_cast<int>(this->Values.size()), coordinate, factor);
    }
    this->Values.push_back(value);
  }

  /// Two places are one.
  void addSame(const Terms& one, const Terms& other)
  {
    for (Eigen::Index d = 0; d < 2; ++d)
    {
      std::vector<std::pair<Eigen::Index, double>> factors;
      for (std::size_t k = 0; k < 4; ++k)
      {
        const auto at = static_cast<Eigen::Index>(k);
        factors.emplace_back(2 * one.unknown[k] + d, one.factor[at]);
        factors.emplace_back(2 * other.unknown[k] + d, -other.factor[at]);
      }
      this->addRow(factors, 0.0);
    }
  }

  void addLengths(const StretchCurve& curve)
  {
    double start = 0.0;
    double length = 0.0;
    for (const FairInterval& interval : curve.stretch().intervals)
    {
      length += interval.length;
      // All parts of a segment have their share of it.
      if (!curve.stretch().straight || &interval == &curve.stretch().intervals.back())
      {
        if (!interval.follows)
        {
          this->Lengths.emplace_back(curve, start, interval.end, length);
        }
        start = interval.end;
        length = 0.0;
      }
    }
  }

  /// Curves are mirror images of each other; nodes that stay are so already.
  void addMirror()
  {
    const MirrorAxis& axis = this->Network.axis;
    // The image of a point p is at + F (p - at).
    const Eigen::Matrix2d image =
      2.0 * axis.along * axis.along.transpose() - Eigen::Matrix2d::Identity();
    const Point2 shift = axis.at - image * axis.at;
    const Point2 across(axis.along.y(), -axis.along.x());
    std::set<std::array<Eigen::Index, 2>> known; // nodes are of two stretches
    for (const MirroredStretches& pair : this->Network.images)
    {
      const std::vector<Eigen::Index> points = this->Curves[pair.one].unknowns();
      std::vector<Eigen::Index> images = this->Curves[pair.other].unknowns();
      std::reverse(images.begin(), images.end());
      for (std::size_t k = 0; k < points.size(); ++k)
      {
        const auto [a, b] = std::minmax(points[k], images[k]);
        const bool stays =
          this->Network.held && a < static_cast<Eigen::Index>(this->Network.nodes.size());
        if (stays || !known.insert({ a, b }).second)
        {
          continue;
        }
        if (a == b)
        {
          this->addRow({ { 2 * a, across.x() }, { 2 * a + 1, across.y() } }, across.dot(axis.at));
          continue;
        }
        for (Eigen::Index d = 0; d < 2; ++d)
        {
          this->addRow(
            { { 2 * b + d, 1.0 }, { 2 * a, -image(d, 0) }, { 2 * a + 1, -image(d, 1) } }, shift[d]);
        }
      }
    }
  }

  void addSquare(const Terms& terms, const Point2& target, const Eigen::Matrix2d& weight)
  {
    for (std::size_t a = 0; a < 4; ++a)
    {
      const double factor = terms.factor[static_cast<Eigen::Index>(a)];
      for (std::size_t b = 0; factor != 0.0 && b < 4; ++b)
      {
        const double both = factor * terms.factor[static_cast<Eigen::Index>(b)];
        for (Eigen::Index k = 0; both != 0.0 && k < 4; ++k)
        {
          this->Squares.emplace_back(2 * terms.unknown[a] + k / 2, 2 * terms.unknown[b] + k % 2,
            both * weight(k / 2, k % 2));
        }
      }
      this->Right.segment<2>(2 * terms.unknown[a]) += factor * (weight * target);
    }
  }

  /// Points may slide along the curve, but where others end on it.
  static Eigen::Matrix2d weightOf(const FairStretch& stretch, std::size_t k)
  {
    const Point2 way = stretch.points[k + 1] - stretch.points[k - 1];
    const double length = way.norm();
    const Point2 along =
      length > 0.0 && !stretch.isHook(k) ? Point2(way / length) : Point2(Point2::Zero());
    return stretch.weights[k] * (stretch.arc[k + 1] - stretch.arc[k - 1]) / 2.0 *
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
      total += stretch.length();
      const std::size_t last = stretch.points.size() - 1;
      for (std::size_t k = 1; k < last; ++k)
      {
        this->addSquare(curve.at(stretch.arc[k], Derivative::Place), stretch.points[k],
          this->weightOf(stretch, k));
      }
      // Corners are what the eye sees: they stay, if the lengths let them.
      const double end = stretch.smoothEnds ? 0.5 : 0.5 * cornerWeight;
      weightOfNode[stretch.from] += end * stretch.weights[0] * stretch.arc[1];
      weightOfNode[stretch.to] +=
        end * stretch.weights[last] * (stretch.length() - stretch.arc[last - 1]);
      for (std::size_t k = 0; !stretch.straight && k + 1 < stretch.breaks.size(); ++k)
      {
        // Gauss's rule of two points: the second derivative is linear, its square quadratic.
        const double half = (stretch.breaks[k + 1] - stretch.breaks[k]) / 2.0;
        for (const double t : { -half / std::sqrt(3.0), half / std::sqrt(3.0) })
        {
          this->addSquare(curve.at(stretch.breaks[k] + half + t, Derivative::Bend), Point2::Zero(),
            bending * half * Eigen::Matrix2d::Identity());
        }
      }
    }
    for (std::size_t k = 0; k < weightOfNode.size(); ++k)
    {
      this->addSquare(nodeTerms(k), this->Network.nodes[k],
        (weightOfNode[k] + 1e-6 * total) * Eigen::Matrix2d::Identity());
    }
    // A knot between two points that are far from each other is held by bending alone.
    for (Eigen::Index k = 0; k < 2 * this->Unknowns; ++k)
    {
      this->Squares.emplace_back(k, k, 1e-12 * total);
    }
  }

  /// The step to the minimum of the objective under the constraints, as they are linearized. Where
  /// these depend on each other it meets them in the mean. Not finite where there is no minimum.
  /// \param pull of the objective; zero: the shortest step to the constraints
  Vector stepOf(const Rows& rows, const Entries& bends, const Vector& pull, const Vector& missing)
  {
    const Eigen::Index unknowns = 2 * this->Unknowns;
    const Eigen::Index size = unknowns + rows.rows();
    Entries entries = this->Squares;
    entries.insert(entries.end(), bends.begin(), bends.end());
    for (Eigen::Index column = 0; column < unknowns; ++column)
    {
      for (Rows::InnerIterator entry(rows, column); entry; ++entry)
      {
        entries.emplace_back(unknowns + entry.row(), column, entry.value());
      }
    }
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
    // Of a minimum: as many negative pivots as there are constraints.
    if (this->System.info() != Eigen::Success ||
      (this->System.vectorD().array() < 0.0).count() != rows.rows())
    {
      return Vector::Constant(unknowns, std::numeric_limits<double>::quiet_NaN());
    }
    Vector right(size);
    right << pull, missing - this->Softness * this->Tensions;
    Vector solution = this->System.solve(right);
    for (int k = 0; k < refinements; ++k)
    {
      solution += this->System.solve(right - system.selfadjointView<Eigen::Lower>() * solution);
    }
    this->Tensions = solution.tail(rows.rows());
    return solution.head(unknowns);
  }

  /// Rows of the constraints, the second derivatives of the lengths, and what is missing to them.
  /// \param leastTension that the second derivatives are taken with
  void constraints(double leastTension, Rows& rows, Entries& bends, Vector& missing) const
  {
    const auto linear = static_cast<Eigen::Index>(this->Values.size());
    Entries entries = this->Linear;
    missing.resize(linear + static_cast<Eigen::Index>(this->Lengths.size()));
    for (std::size_t r = 0; r < this->Lengths.size(); ++r)
    {
      const auto k = static_cast<Eigen::Index>(r);
      missing[linear + k] = this->Lengths[r].add(
        linear + k, std::max(leastTension, this->Tensions[linear + k]), this->X, entries, bends);
    }
    rows.resize(missing.size(), 2 * this->Unknowns);
    rows.setFromTriplets(entries.begin(), entries.end());
    missing.head(linear) =
      Eigen::Map<const Vector>(this->Values.data(), linear) - (rows * this->X).head(linear);
  }

  /// The largest of what is missing, relative to lengths.
  double largestOf(const Vector& missing) const
  {
    double most = 0.0;
    // What lies below the last digits of coordinates cannot be made better.
    const double rounding =
      16.0 * std::numeric_limits<double>::epsilon() * this->X.lpNorm<Eigen::Infinity>();
    const auto linear = static_cast<Eigen::Index>(this->Values.size());
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
    Rows hessian(2 * this->Unknowns, 2 * this->Unknowns);
    hessian.setFromTriplets(this->Squares.begin(), this->Squares.end());
    this->Squares.clear(); // each step adds them: once summed they are far fewer
    for (Eigen::Index outer = 0; outer < hessian.outerSize(); ++outer)
    {
      for (Rows::InnerIterator entry(hessian, outer); entry; ++entry)
      {
        this->Squares.emplace_back(
          static_cast<int>(entry.row()), static_cast<int>(entry.col()), entry.value());
      }
    }
    const Eigen::SimplicialLDLT<Rows> factor(hessian);
    if (factor.info() != Eigen::Success)
    {
      return false;
    }
    this->Softness = softness / hessian.diagonal().mean();
    const Vector free = factor.solve(this->Right); // the minimum without constraints
    this->X = free;
    for (const CurveLength& length : this->Lengths)
    {
      this->Longest = std::max(this->Longest, length.wanted());
    }
    this->Tensions =
      Vector::Zero(static_cast<Eigen::Index>(this->Values.size() + this->Lengths.size()));
    double last = 1.0;
    double least = infinity;
    int stuck = 0;
    for (int step = 0; step < steps; ++step)
    {
      Rows rows;
      Entries bends;
      Vector missing;
      this->constraints(-infinity, rows, bends, missing);
      last = this->largestOf(missing);
      stuck = step < steps / 3 || last < 0.5 * least ? 0 : stuck + 1;
      least = std::min(least, last);
      if (!missing.allFinite() || stuck > patience)
      {
        return last <= goodLength;
      }
      if (last < exactLength && (step == 0 || step > steps / 3))
      {
        return true;
      }
      // The first steps look for the minimum, the last ones for the lengths alone.
      const bool towardsMinimum = step < steps / 3;
      const Vector pull =
        towardsMinimum ? Vector(hessian * (free - this->X)) : Vector(0.0 * this->X);
      if (!towardsMinimum)
      {
        this->Tensions.setZero();
      }
      Vector change = this->stepOf(rows, bends, pull, missing);
      if (!change.allFinite()) // lengths that push may make the objective less than convex
      {
        bends.clear();
        this->constraints(0.0, rows, bends, missing);
        change = this->stepOf(rows, bends, pull, missing);
      }
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
      if (towardsMinimum && most < goodStep * this->Longest && last < goodStep)
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
  Entries Linear;             ///< conditions of coordinates of the unknown points
  std::vector<double> Values; ///< of these
  Entries Squares;            ///< of the objective
  Vector Right;
  Eigen::SimplicialLDLT<Rows> System; ///< with the constraints
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
