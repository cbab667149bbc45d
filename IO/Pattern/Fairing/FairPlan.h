// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/BorderChains.h"
#include "Outlines/FairSpan.h"

#include <limits>

namespace flattening::pattern
{
/// A part of a chain between two stops: notches, corners of either side of a seam, ends of curves.
struct PlannedInterval
{
  double start = 0.0; ///< along the chain
  double end = 0.0;
  std::array<double, 2> places{ 0.0, 0.0 }; ///< of its ends along the spans of the chain
  double length = 0.0;    ///< that its curve must have, the same on both sides of a seam
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

inline constexpr double sameLength = 1e-6; ///< of both sides of a seam, relative
constexpr double inexact = 1e-6;           ///< of a stretch: bent by less it is a segment already

/// A part of a chain between two corners.
struct PlannedStretch
{
  std::size_t firstPoint = 0; ///< of the chain
  std::size_t lastPoint = 0;
  std::size_t firstInterval = 0;
  std::size_t endInterval = 0; ///< the one after its last
  bool smoothEnds = false;     ///< a ring without a corner
  StretchForm form = StretchForm::Spline;
  double bend = 0.0;           ///< distance of its points from its chord, at most
  std::vector<double> breaks;  ///< of its spline, along the chain, its ends among them
  std::vector<double> weights; ///< of its points, from the first to the last
  double excess = std::numeric_limits<double>::infinity(); ///< of its points over their tolerances
  int futile = 0; ///< how often in a row more breaks were of no help

  std::size_t edges() const { return this->lastPoint - this->firstPoint; }
  std::size_t spans() const { return this->breaks.size() - 1; }
  std::size_t leastSpans() const { return this->smoothEnds ? 4 : 1; }
};

struct PlannedChain
{
  std::vector<PlannedInterval> intervals;
  std::vector<PlannedStretch> stretches;
};

/// A stretch of a plan.
struct StretchPlace
{
  std::size_t chain = 0;
  std::size_t stretch = 0;

  bool operator==(const StretchPlace& other) const
  {
    return this->chain == other.chain && this->stretch == other.stretch;
  }
};

/// What may be done to each piece.
struct FairLimits
{
  std::vector<double> shares; ///< of its tolerances that it may use
  std::vector<bool> mirrored; ///< its outline is to be its own mirror image, where it nearly is
};

/// Into which stretches and intervals the chains fall.
/// \param shares which part of its tolerances each piece may use
std::vector<PlannedChain> planFairBorders(
  const DrawingSource& all, const BorderChains& chains, const std::vector<double>& shares);

/// The stretch that an interval is a part of.
const PlannedStretch& stretchOf(const PlannedChain& chain, std::size_t interval);

/// Of the points of a stretch from their curve, at a place along the chain, millimetres.
double toleranceAt(const PlannedChain& chain, const PlannedStretch& stretch, double arc);

constexpr double sameBreak = 1e-7; ///< of an interval

/// The smooth curve of an interval, measured along itself.
class IntervalCurve
{
public:
  /// \param spans of the chain \param places of its ends along them
  IntervalCurve(const std::vector<FairSpan>& spans, const std::array<double, 2>& places);

  double length() const { return this->Length; }
  /// Where it is divided, as shares of its length. \param fromEnd the shares are those from its end
  std::vector<double> breaks(bool fromEnd) const;
  /// The place along the chain at a share of the length.
  double placeAt(double share) const;

private:
  double Start = 0.0;
  double End = 0.0;
  double Length = 0.0;
  std::vector<FairSpan> Parts;
};
}
