// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BorderChains.h"

namespace flattening
{
namespace pattern
{
/// A part of a chain between two stops: notches, corners of either side of a seam, ends of curves.
struct PlannedInterval
{
  double start = 0.0; ///< along the chain
  double end = 0.0;
  double length = 0.0;    ///< that its curve must have, the same on both sides of a seam
  int spans = 1;          ///< of its spline
  int least = 1;          ///< fewer of them do not keep the tolerance
  int most = 1;           ///< that make sense: one an edge of the mesh, and one more
  double tolerance = 0.0; ///< of its points from its curve, millimetres; 0: it stays as it was
  std::array<std::size_t, 2> partner{ none, none }; ///< chain and interval that it is sewn to
  bool reversed = false;                            ///< the partner's chain runs the other way

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

enum class StretchForm
{
  Spline,
  Straight, ///< because it lies within the tolerance of its chord
  Raw,      ///< as it was, edge by edge
};

constexpr double inexact = 1e-6; ///< of a stretch: bent by less it is a segment already

/// A part of a chain between two corners.
struct PlannedStretch
{
  std::size_t firstPoint = 0; ///< of the chain
  std::size_t lastPoint = 0;
  std::size_t firstInterval = 0;
  std::size_t endInterval = 0; ///< the one after its last
  bool smoothEnds = false;     ///< a ring without a corner
  StretchForm form = StretchForm::Spline;
  double bend = 0.0; ///< distance of its points from its chord, at most
};

struct PlannedChain
{
  std::vector<PlannedInterval> intervals;
  std::vector<PlannedStretch> stretches;
};

/// Into which stretches and intervals the chains fall.
/// \param shares which part of its tolerances each piece may use
std::vector<PlannedChain> planFairBorders(
  const DrawingSource& all, const BorderChains& chains, const std::vector<double>& shares);

/// Gives both sides of each interval as many spans as the one of them that needs more.
void agreeOnSpans(std::vector<PlannedChain>& plan);
}
}
