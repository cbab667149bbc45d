// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <algorithm>

namespace flattening
{
/// The cross product of two vectors of the plane: the area that they span, positive where v lies to
/// the left of u.
inline double cross(const Point2& u, const Point2& v)
{
  return u.x() * v.y() - u.y() * v.x();
}

/// How far a point of a polyline lies from the segment that joins its ends, at most.
inline double farthestFromChord(const Points2& line)
{
  const Point2& from = line.front();
  const Point2 chord = line.back() - from;
  const double square = chord.squaredNorm();
  double farthest = 0.0;
  for (const Point2& p : line)
  {
    const Point2 q = p - from;
    const double along = square > 0.0 ? std::clamp(q.dot(chord) / square, 0.0, 1.0) : 0.0;
    farthest = std::max(farthest, (q - along * chord).norm());
  }
  return farthest;
}
}
