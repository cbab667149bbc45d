// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/FairSpan.h"

#include <algorithm>
#include <cmath>

namespace flattening::pattern
{
namespace
{
constexpr int mostParts = 10000; ///< chords of a span
/// Of a curve by its arc length: 1 where it runs evenly, 0 at a cusp.
constexpr double leastSpeed = 0.25;
constexpr int placesOfTurns = 32; ///< between them no drawn curve turns by a right angle
}

Point2 FairSpan::at(double arc) const
{
  const double u = (arc - this->from) / (this->to - this->from);
  const double v = 1.0 - u;
  return v * v * v * this->control[0] + 3.0 * u * v * v * this->control[1] +
    3.0 * u * u * v * this->control[2] + u * u * u * this->control[3];
}

Point2 FairSpan::slope(double arc) const
{
  const double u = (arc - this->from) / (this->to - this->from);
  const double v = 1.0 - u;
  const Point2 byParameter = 3.0 *
    (v * v * (this->control[1] - this->control[0]) +
      2.0 * u * v * (this->control[2] - this->control[1]) +
      u * u * (this->control[3] - this->control[2]));
  return byParameter / (this->to - this->from);
}

bool FairSpan::straight() const
{
  const Point2 third = (this->control[3] - this->control[0]) / 3.0;
  const double off = std::max((this->control[1] - this->control[0] - third).norm(),
    (this->control[3] - this->control[2] - third).norm());
  return off < 1e-6 * third.norm();
}

bool FairSpan::turnsBack() const
{
  Point2 before = Point2::Zero();
  for (int k = 0; k <= placesOfTurns; ++k)
  {
    const Point2 slope = this->slope(this->from + (this->to - this->from) * k / placesOfTurns);
    if (slope.norm() < leastSpeed || slope.dot(before) < 0.0)
    {
      return true;
    }
    before = slope;
  }
  return false;
}

double FairSpan::length() const
{
  double length = 0.0;
  integrate(this->from, this->to, spanParts,
    [&](double t, double weight) { length += weight * this->slope(t).norm(); });
  return std::abs(length); // the way back has a negative one
}

double curveLength(const std::vector<FairSpan>& curve)
{
  double length = 0.0;
  for (const FairSpan& span : curve)
  {
    length += span.length();
  }
  return length;
}

void sampleSpan(const FairSpan& span, double distance, Points2& points)
{
  const auto bend = [&span](std::size_t k) {
    return (span.control[k] - 2.0 * span.control[k + 1] + span.control[k + 2]).norm();
  };
  // A chord over 1 / n of a cubic curve is off by no more than 6 / (8 n^2) of these differences.
  const double most = 0.75 * std::max(bend(0), bend(1));
  const double wanted = std::ceil(std::sqrt(most / distance));
  const int parts = wanted < mostParts ? std::max(1, static_cast<int>(wanted)) : mostParts;
  for (int k = 0; k < parts; ++k)
  {
    points.push_back(span.at(span.from + (span.to - span.from) * k / parts));
  }
}

Points2 sampled(const std::vector<FairSpan>& curve)
{
  Points2 points;
  for (const FairSpan& span : curve)
  {
    sampleSpan(span, sampleDistance, points);
  }
  points.push_back(curve.back().control[3]);
  return points;
}

FairSpan partOf(const FairSpan& span, double from, double to)
{
  const double third = (to - from) / 3.0;
  return { from, to,
    { span.at(from), span.at(from) + third * span.slope(from), span.at(to) - third * span.slope(to),
      span.at(to) } };
}

const FairSpan& spanAt(const std::vector<FairSpan>& spans, double arc)
{
  const auto found = std::partition_point(
    spans.begin(), spans.end() - 1, [arc](const FairSpan& span) { return span.to < arc; });
  return *found;
}
}
