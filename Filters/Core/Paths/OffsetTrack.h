// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/OffsetWindow.h"

#include <vector>

namespace flattening
{
/// Stretches of a track by where along it they begin and end.
using TrackParts = std::vector<SegmentPart>;

/// Where a window ends: a line at the distance of a strip, or an arc round the apex of a sector, in
/// the order of the path, which is on its right.
class OffsetTrack
{
public:
  explicit OffsetTrack(const OffsetWindow& window);

  /// As lengths of a line, and angles of an arc, clockwise.
  const SegmentPart& whole() const { return this->Whole; }
  bool isArc() const { return this->Radius > 0.0; }
  double radius() const { return this->Radius; }
  Point2 at(double along) const;
  /// Where tangents at two places of an arc meet.
  Point2 tangentsMeet(double from, double to) const;

  /// Where gradient.dot(place) + constant is not negative.
  TrackParts where(const Point2& gradient, double constant) const;
  TrackParts inDisc(const Point2& center, double radius) const;

private:
  SegmentPart Whole;
  Point2 Origin; ///< of a line; centre of an arc
  Point2 Way;
  double Radius = 0.0; ///< 0: a line
};

TrackParts intersection(const TrackParts& a, const TrackParts& b);
/// What is left of the first ones, in order.
TrackParts difference(const TrackParts& a, const TrackParts& b);
}
