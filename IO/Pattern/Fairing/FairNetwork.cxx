// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairNetwork.h"

#include "Base/Types.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>

namespace flattening::pattern
{
CubicBasis::CubicBasis(const std::vector<double>& breaks)
  : Breaks(breaks)
  , Knots(2, breaks.front())
{
  for (const double at : breaks)
  {
    this->Knots.insert(this->Knots.end(), 2, at);
  }
  this->Knots.insert(this->Knots.end(), 2, breaks.back());
}

CubicBasis::Values CubicBasis::at(double t) const
{
  const auto after = std::upper_bound(this->Breaks.begin(), this->Breaks.end(), t);
  const std::size_t above = static_cast<std::size_t>(after - this->Breaks.begin());
  return this->at(std::clamp<std::size_t>(above, 1, this->Breaks.size() - 1) - 1, t);
}

CubicBasis::Values CubicBasis::at(std::size_t span, double t) const
{
  const std::size_t i = 2 * span + 3; // the knot at the start of the span
  const auto knot = [this](std::size_t k) { return this->Knots[k]; };
  // Functions of degree 0 to 3 that are not zero in the span.
  std::array<std::array<double, 4>, 4> functions{};
  functions[0][0] = 1.0;
  for (std::size_t degree = 1; degree <= 3; ++degree)
  {
    double saved = 0.0;
    for (std::size_t r = 0; r < degree; ++r)
    {
      const double right = knot(i + r + 1);
      const double left = knot(i + r + 1 - degree);
      const double part = functions[degree - 1][r] / (right - left);
      functions[degree][r] = saved + (right - t) * part;
      saved = (t - left) * part;
    }
    functions[degree][degree] = saved;
  }
  Values values;
  values.first = 2 * span;
  values.value = functions[3];
  // Function r of a degree has the knots from i - degree + r on.
  const auto width = [&](std::size_t degree, std::size_t r) {
    return knot(i + r) - knot(i + r - degree);
  };
  // Slopes of the quadratic functions.
  std::array<double, 3> slopes{};
  for (std::size_t r = 0; r < 3; ++r)
  {
    const double rise = r > 0 ? functions[1][r - 1] / width(2, r) : 0.0;
    const double fall = r < 2 ? functions[1][r] / width(2, r + 1) : 0.0;
    slopes[r] = 2.0 * (rise - fall);
  }
  for (std::size_t r = 0; r < 4; ++r)
  {
    const double before = r > 0 ? 1.0 / width(3, r) : 0.0;
    const double after = r < 3 ? 1.0 / width(3, r + 1) : 0.0;
    values.slope[r] = 3.0 *
      ((r > 0 ? functions[2][r - 1] * before : 0.0) - (r < 3 ? functions[2][r] * after : 0.0));
    values.bend[r] =
      3.0 * ((r > 0 ? slopes[r - 1] * before : 0.0) - (r < 3 ? slopes[r] * after : 0.0));
  }
  return values;
}

Point2 sum(const Terms& terms, const Eigen::VectorXd& x)
{
  Point2 result = Point2::Zero();
  for (const Term& term : terms)
  {
    result += term.factor * x.segment<2>(2 * term.unknown);
  }
  return result;
}

StretchCurve::StretchCurve(const FairStretch& stretch, Eigen::Index& next)
  : Stretch(stretch)
  , Basis(stretch.breaks)
  , First(next)
{
  next += stretch.straight ? 0 : static_cast<Eigen::Index>(this->Basis.size()) - 2;
}

std::vector<Eigen::Index> StretchCurve::unknowns() const
{
  std::vector<Eigen::Index> unknowns{ static_cast<Eigen::Index>(this->Stretch.from) };
  for (std::size_t j = 2; !this->Stretch.straight && j < this->Basis.size(); ++j)
  {
    unknowns.push_back(this->First + static_cast<Eigen::Index>(j) - 2);
  }
  unknowns.push_back(static_cast<Eigen::Index>(this->Stretch.to));
  return unknowns;
}

Terms StretchCurve::at(double t, Derivative derivative) const
{
  const auto from = static_cast<Eigen::Index>(this->Stretch.from);
  const auto to = static_cast<Eigen::Index>(this->Stretch.to);
  if (this->Stretch.straight)
  {
    const double length = this->Stretch.length();
    const double s = derivative == Derivative::Place ? t / length
      : derivative == Derivative::Slope              ? 1.0 / length
                                                     : 0.0;
    return { { from, (derivative == Derivative::Place ? 1.0 : 0.0) - s }, { to, s } };
  }
  const CubicBasis::Values values = this->Basis.at(t);
  const std::array<double, 4>& factors = derivative == Derivative::Place ? values.value
    : derivative == Derivative::Slope                                    ? values.slope
                                                                         : values.bend;
  Terms terms;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const std::size_t j = values.first + k;
    const Eigen::Index unknown = j == 0 ? from
      : j + 1 == this->Basis.size()     ? to
                                        : this->First + static_cast<Eigen::Index>(j) - 1;
    terms.push_back({ unknown, factors[k] });
  }
  return terms;
}

std::vector<FairSpan> StretchCurve::spans(const Eigen::VectorXd& x) const
{
  std::vector<FairSpan> spans;
  const std::vector<double>& breaks = this->Basis.breaks();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    FairSpan span;
    span.from = breaks[k];
    span.to = breaks[k + 1];
    const double third = (span.to - span.from) / 3.0;
    const auto value = [&](double t, Derivative derivative) {
      return sum(this->at(t, derivative), x);
    };
    // The curve is differentiable, so that the side of a break does not matter.
    span.control[0] = value(span.from, Derivative::Place);
    span.control[3] = value(span.to, Derivative::Place);
    span.control[1] = span.control[0] + third * value(span.from, Derivative::Slope);
    span.control[2] = span.control[3] - third * value(span.to, Derivative::Slope);
    spans.push_back(span);
  }
  return spans;
}

std::vector<double> StretchCurve::deviation(
  const Points2& nodes, const Eigen::VectorXd& x, std::vector<double>& nearest) const
{
  const FairStretch& stretch = this->Stretch;
  const auto end = [&](std::size_t node) {
    return (nodes[node] - x.segment<2>(2 * static_cast<Eigen::Index>(node))).norm();
  };
  std::vector<double> deviation{ end(stretch.from) };
  for (std::size_t k = 0; k < stretch.points.size(); ++k)
  {
    double t = stretch.arc[k];
    Point2 slope;
    Point2 off;
    for (int step = 0; step < 4; ++step)
    {
      slope = sum(this->at(t, Derivative::Slope), x);
      off = stretch.points[k] - sum(this->at(t, Derivative::Place), x);
      t = std::clamp(
        t + slope.dot(off) / std::max(slope.squaredNorm(), 1e-24), 0.0, stretch.length());
    }
    deviation.push_back(std::abs(cross(slope, off)) / std::max(slope.norm(), 1e-12));
    nearest.push_back(t);
  }
  deviation.push_back(end(stretch.to));
  return deviation;
}

CurveLength::CurveLength(const StretchCurve& curve, double from, double to, double wanted)
  : Wanted(wanted)
{
  const auto add = [&](double end) {
    Part& part = this->Parts.emplace_back();
    integrate(from, end, [&](double t, double weight) {
      const Terms slope = curve.at(t, Derivative::Slope);
      std::array<double, 4>& factors = part.factors.emplace_back();
      for (std::size_t k = 0; k < slope.size(); ++k)
      {
        factors[k] = slope[k].factor;
      }
      part.weights.push_back(weight);
      part.unknowns = part.weights.size() == 1 ? slope : part.unknowns;
    });
    from = end;
  };
  const std::vector<double>& breaks = curve.basis().breaks();
  for (auto at = std::upper_bound(breaks.begin(), breaks.end(), from);
       at != breaks.end() && *at < to; ++at)
  {
    add(*at);
  }
  add(to);
}

Point2 CurveLength::Part::slope(std::size_t place, const Eigen::VectorXd& x) const
{
  Point2 slope = Point2::Zero();
  for (std::size_t k = 0; k < this->unknowns.size(); ++k)
  {
    slope += this->factors[place][k] * x.segment<2>(2 * this->unknowns[k].unknown);
  }
  return slope;
}

double CurveLength::addRow(Eigen::Index row, const Eigen::VectorXd& x, Entries& entries) const
{
  double length = 0.0;
  for (const Part& part : this->Parts)
  {
    std::array<Point2, 4> derivative{ Point2::Zero(), Point2::Zero(), Point2::Zero(),
      Point2::Zero() };
    for (std::size_t place = 0; place < part.weights.size(); ++place)
    {
      const Point2 slope = part.slope(place, x);
      const double speed = slope.norm();
      length += part.weights[place] * speed;
      const Point2 unit = speed > 0.0 ? Point2(slope / speed) : Point2(Point2::Zero());
      for (std::size_t k = 0; k < part.unknowns.size(); ++k)
      {
        derivative[k] += part.weights[place] * part.factors[place][k] * unit;
      }
    }
    for (std::size_t k = 0; k < part.unknowns.size(); ++k)
    {
      for (Eigen::Index d = 0; d < 2; ++d)
      {
        entries.emplace_back(row, 2 * part.unknowns[k].unknown + d, derivative[k][d]);
      }
    }
  }
  return this->Wanted - length;
}

void CurveLength::addTension(double tension, const Eigen::VectorXd& x, Entries& entries) const
{
  for (const Part& part : this->Parts)
  {
    const auto size = static_cast<Eigen::Index>(part.unknowns.size());
    Eigen::Matrix<double, 8, 8> block = Eigen::Matrix<double, 8, 8>::Zero();
    for (std::size_t place = 0; tension != 0.0 && place < part.weights.size(); ++place)
    {
      const Point2 slope = part.slope(place, x);
      const double speed = slope.norm();
      if (!(speed > 0.0))
      {
        continue;
      }
      const Eigen::Matrix2d across =
        (Eigen::Matrix2d::Identity() - slope * slope.transpose() / (speed * speed)) *
        (tension * part.weights[place] / speed);
      const std::array<double, 4>& factors = part.factors[place];
      for (Eigen::Index a = 0; a < size; ++a)
      {
        for (Eigen::Index b = 0; b < size; ++b)
        {
          block.block<2, 2>(2 * a, 2 * b) +=
            factors[static_cast<std::size_t>(a)] * factors[static_cast<std::size_t>(b)] * across;
        }
      }
    }
    const auto unknown = [&part](Eigen::Index at) {
      return 2 * part.unknowns[static_cast<std::size_t>(at / 2)].unknown + at % 2;
    };
    for (Eigen::Index a = 0; a < 2 * size; ++a)
    {
      for (Eigen::Index b = 0; b < 2 * size; ++b)
      {
        entries.emplace_back(unknown(a), unknown(b), block(a, b));
      }
    }
  }
}

void LinearRows::addPoint(const Terms& terms, const Point2& value)
{
  for (Eigen::Index d = 0; d < 2; ++d)
  {
    Row& row = this->Rows.emplace_back();
    row.value = value[d];
    for (const Term& term : terms)
    {
      row.factors.emplace_back(2 * term.unknown + d, term.factor);
    }
  }
}

void LinearRows::addHeld(const Points2& points)
{
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    this->addPoint({ { static_cast<Eigen::Index>(k), 1.0 } }, points[k]);
  }
}

void LinearRows::addHooksAndRings(const std::vector<StretchCurve>& curves)
{
  for (const StretchCurve& curve : curves)
  {
    const FairStretch& stretch = curve.stretch();
    for (const FairHook& hook : stretch.hooks)
    {
      Terms terms = curve.at(hook.at, Derivative::Place);
      terms.push_back({ static_cast<Eigen::Index>(hook.node), -1.0 });
      this->addPoint(terms, Point2::Zero());
    }
    if (stretch.smoothEnds)
    {
      Terms terms = curve.at(0.0, Derivative::Slope);
      for (const Term& term : curve.at(stretch.length(), Derivative::Slope))
      {
        terms.push_back({ term.unknown, -term.factor });
      }
      this->addPoint(terms, Point2::Zero());
    }
  }
}

void LinearRows::addMirror(const FairNetwork& network, const std::vector<StretchCurve>& curves)
{
  const FairMirror& mirror = network.mirror;
  // The image of a point p is at + F (p - at).
  const Eigen::Matrix2d image =
    2.0 * mirror.along * mirror.along.transpose() - Eigen::Matrix2d::Identity();
  const Point2 shift = mirror.at - image * mirror.at;
  const Point2 across(mirror.along.y(), -mirror.along.x());
  std::set<std::array<Eigen::Index, 2>> known; // nodes are of two stretches
  for (const FairImages& pair : mirror.stretches)
  {
    const std::vector<Eigen::Index> points = curves[pair.one].unknowns();
    std::vector<Eigen::Index> images = curves[pair.other].unknowns();
    std::reverse(images.begin(), images.end());
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const Eigen::Index a = std::min(points[k], images[k]);
      const Eigen::Index b = std::max(points[k], images[k]);
      const bool stays = network.held && a < static_cast<Eigen::Index>(network.nodes.size());
      if (stays || !known.insert({ a, b }).second)
      {
        continue;
      }
      if (a == b)
      {
        this->Rows.push_back(
          { { { 2 * a, across.x() }, { 2 * a + 1, across.y() } }, across.dot(mirror.at) });
        continue;
      }
      for (Eigen::Index d = 0; d < 2; ++d)
      {
        this->Rows.push_back(
          { { { 2 * b + d, 1.0 }, { 2 * a, -image(d, 0) }, { 2 * a + 1, -image(d, 1) } },
            shift[d] });
      }
    }
  }
}

void LinearRows::add(const Eigen::VectorXd& x, std::vector<Eigen::Triplet<double>>& entries,
  Eigen::VectorXd& missing) const
{
  for (Eigen::Index r = 0; r < this->size(); ++r)
  {
    const Row& row = this->Rows[static_cast<std::size_t>(r)];
    missing[r] = row.value;
    for (const auto& [coordinate, factor] : row.factors)
    {
      entries.emplace_back(r, coordinate, factor);
      missing[r] -= factor * x[coordinate];
    }
  }
}
}
