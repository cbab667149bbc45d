// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Angles/AngleSolution.h"

namespace flattening
{
/// What came of flattening the piece without a curve, or without the shape of a key curve.
struct ReleaseTrial
{
  Index curve = none;
  bool solved = false;      ///< all else is without meaning where it is not
  double objective = 0.0;   ///< of Eq. 13, on the flat piece
  double areaError = 0.0;   ///< E_area
  double homogeneity = 0.0; ///< E_h
};

/// Which feature curves keep a piece from a better solution.
struct ReleaseAdvice
{
  /// Per feature curve dF* / d ln(length): how the optimum of Eq. 13 changes when all edges of the
  /// curve grow in proportion. 0 for curves that have no edge inside the piece. It is that of the
  /// wires' angles, from which the isometric scheme starts.
  std::vector<double> sensitivity;
  /// Curves with an edge inside the piece, and, where releases were tried, key curves with one on
  /// its boundary: tried ones first, the best first; then by the magnitude of their sensitivity;
  /// ties by the smaller id.
  Indices ranking;
  /// Per curve of the ranking what came of its release; not solved where that was not tried.
  std::vector<ReleaseTrial> trials;

  /// The trial of the first curve of the ranking; not solved where there is none.
  ReleaseTrial first() const
  {
    return this->trials.empty() ? ReleaseTrial() : this->trials.front();
  }
};

/// What the multipliers of the wires' solution say, without a trial; empty where it has none, as
/// progressive solutions.
ReleaseAdvice adviseRelease(const WireNetwork& network, const std::vector<FeatureCurve>& curves,
  const AngleSolution& solution);

/// The three curves whose lengths and the three keys whose shapes cost most. \param keys of the
/// piece (keyCurves()); \param released keys whose shapes are given up already: their lengths are
/// left to release.
Indices releaseCandidates(const ReleaseAdvice& advice, const WireNetwork& network,
  const std::vector<FeatureCurve>& curves, Indices keys, const Indices& released,
  const AngleSolution& solution);

/// What a trial is judged by: what its scheme minimizes.
enum class ReleaseMeasure
{
  Objective, ///< of Eq. 13
  AreaError, ///< E_area; a trial with a flipped triangle comes after all without
};

/// Ranks the curves anew with what came of the trials.
void rankReleases(
  const std::vector<ReleaseTrial>& trials, ReleaseMeasure measure, ReleaseAdvice& advice);
}
