// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Imprint/ImprintedSurface.h"
#include "Suggestion/RegionWeights.h"
#include "Suggestion/SearchOptions.h"
#include "Suggestion/SuggestedCurve.h"
#include "Suggestion/SurfaceMirror.h"

#include <optional>

namespace flattening
{
struct SuggestionOptions
{
  SearchOptions search;
  /// Where distortion matters: cuts are chosen by energies and strains for which each triangle's
  /// area counts so many times. Keeps no mirror plane that does not mirror it as well. Of no effect
  /// on lines.
  RegionWeights weights;
  ImprintOptions imprint;
  /// As the flattening to come will use them.
  FlatteningOptions flattening;
};

struct CurveSuggestions
{
  std::vector<SuggestedCurve> curves;
  /// Lines that were tried and cost too much.
  std::vector<SuggestedCurve> leftOut;
  std::optional<SurfaceMirror> mirror; ///< where some are mirror images of others
  double strainBefore = 0.0;           ///< largest p95 strain of a piece; NaN as in SuggestedCurve
  double strainAfter = 0.0;
  double rigidEnergyBefore = 0.0;
  double rigidEnergyAfter = 0.0;
  bool boundMet = false;
  Index trials = 0;
  double work = 0.0; ///< of the trials, in the unit of SearchOptions::maximumWork
  /// Of the search whose cuts are proposed; WorkUsedUp where that ended any.
  SearchEnd end = SearchEnd::NothingHelps;
  double cutsNeeded = 0.0;            ///< where it was given up, see CutSet
  Point3 worstPlace = Point3::Zero(); ///< where the strain is largest that is left
  Status status;
};
}
