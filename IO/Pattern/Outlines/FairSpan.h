// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <array>
#include <vector>

namespace flattening::pattern
{
/// One cubic Bezier curve of a stretch, over a part of its length.
struct FairSpan
{
  double from = 0.0;
  double to = 0.0;
  std::array<Point2, 4> control{};

  Point2 at(double arc) const;
  Point2 slope(double arc) const; ///< derivative by arc length
  bool straight() const;          ///< and run evenly, to a millionth of its length
  /// Whether it runs back on itself, or nearly so, as a curve may that has more length than its
  /// points need.
  bool turnsBack() const;
  double length() const; ///< to rounding for what nearly runs by arc length
};

double curveLength(const std::vector<FairSpan>& curve);

/// How far chords of a drawn curve may be from it, millimetres.
inline constexpr double sampleDistance = 0.02;

/// Adds points along a curve, without its last one, whose chords are within a distance of it.
void sampleSpan(const FairSpan& span, double distance, Points2& points);

/// A curve as it is drawn, from end to end.
Points2 sampled(const std::vector<FairSpan>& curve);

/// The part of a Bezier curve between two places, or the way back where they descend.
FairSpan partOf(const FairSpan& span, double from, double to);

/// The one that holds a place.
const FairSpan& spanAt(const std::vector<FairSpan>& spans, double arc);

/// Parts of a span that its length is integrated over.
inline constexpr int spanParts = 4;

/// Calls f(t, weight) at the places of Gauss's rule of eight points on each part of an
/// interval. By that on quarters of a span its length is exact to rounding though its speed be
/// uneven.
template <typename Function>
void integrate(double from, double to, int parts, const Function& f)
{
  // Half of the rule on [-1, 1]. M. Abramowitz, I. Stegun, Handbook of Mathematical Functions,
  // table 25.4.
  constexpr std::array<double, 4> place{ 0.183434642495649804936, 0.525532409916328985818,
    0.796666477413626739592, 0.960289856497536231684 };
  constexpr std::array<double, 4> share{ 0.362683783378361982965, 0.313706645877887287338,
    0.222381034453374470544, 0.101228536290376259153 };
  const double half = (to - from) / (2.0 * parts);
  for (int part = 0; part < parts; ++part)
  {
    const double middle = from + (2.0 * part + 1.0) * half;
    for (std::size_t k = 0; k < 4; ++k)
    {
      for (const double sign : { -1.0, 1.0 })
      {
        f(middle + sign * half * place[k], half * share[k]);
      }
    }
  }
}
}
