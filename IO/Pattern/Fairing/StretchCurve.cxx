// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/StretchCurve.h"

#include "Base/Types.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace pattern
{
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
}
}
