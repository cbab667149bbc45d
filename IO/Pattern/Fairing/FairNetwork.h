// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/FairSpan.h"
#include "Outlines/MirrorPairs.h"

#include <cstddef>
#include <vector>

namespace flattening::pattern
{
/// A part of a stretch whose length is prescribed: from notch to notch, say.
struct FairInterval
{
  double end = 0.0;     ///< along the stretch
  double length = 0.0;  ///< that it must have
  bool follows = false; ///< it has that if others have theirs, whose mirror image it is
};

/// A node that a stretch runs through.
struct FairHook
{
  double at = 0.0; ///< along the stretch
  std::size_t node = 0;
};

/// What is to be drawn as one smooth curve, between two nodes or, closed, from a node to itself.
struct FairStretch
{
  std::size_t from = 0;
  std::size_t to = 0;
  bool smoothEnds = false;        ///< from == to, and the curve is smooth there
  bool straight = false;          ///< a segment; its intervals divide it by their lengths
  Points2 points;                 ///< where it ran before, from end to end
  std::vector<double> arc;        ///< of the points along the stretch, ascending from 0
  std::vector<double> weights;    ///< of the points, 1 for what is usual
  std::vector<double> tolerances; ///< of the points
  std::vector<double> breaks; ///< along it, between which it is one cubic curve, its ends included
  std::vector<FairInterval> intervals; ///< the last one ends where the stretch does
  std::vector<FairHook> hooks;

  double length() const { return this->intervals.back().end; }
  bool isHook(std::size_t point) const;
};

/// Two stretches that are mirror images of each other, so that one runs the other way; or one that
/// is its own, twice.
struct MirroredStretches
{
  std::size_t one = 0;
  std::size_t other = 0;

  bool own() const { return this->one == this->other; }
};

/// The borders and feature curves of a flat piece that hang together at nodes.
struct FairNetwork
{
  Points2 nodes;     ///< where they were before
  bool held = false; ///< they stay there
  std::vector<FairStretch> stretches;
  MirrorAxis axis;
  std::vector<MirroredStretches> images; ///< at the axis, with breaks that are mirrored as well
};

struct FairCurves
{
  using Lists = std::vector<std::vector<double>>; ///< by stretch, of its points

  bool converged = false; ///< every interval has its length to 1e-10 of it; else the rest is empty
  Points2 nodes;
  std::vector<std::vector<FairSpan>> spans; ///< of each stretch
  Lists deviation;                          ///< across it
  Lists nearest;                            ///< along it, to the points
};

/// Smooth curves of prescribed lengths near given points: least bending (the integral of the
/// squared second derivative) and least squared distance, weighed by a length of waves that are
/// smoothed away, under exact lengths, by Newton's method on the Lagrangian, without the curvature
/// of lengths that push where it would leave no minimum. Curves are piecewise cubic and
/// continuously differentiable.
/// \param wave the longest wave that is smoothed away, in the unit of the points
FairCurves solveFairNetwork(const FairNetwork& network, double wave);
}
