// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Flattening/FlatteningOptions.h"
#include "Imprint/ImprintedSurface.h"
#include "Suggestion/MirrorPlane.h"
#include "Suggestion/SearchOptions.h"
#include "Suggestion/SuggestedCurve.h"

#include <optional>

namespace flattening
{
struct SuggestionOptions
{
  SearchOptions search;
  ImprintOptions imprint;
  /// As the flattening to come will use them.
  FlatteningOptions flattening;
};

struct CurveSuggestions
{
  std::vector<SuggestedCurve> cuts;
  std::optional<MirrorPlane> mirror;
  double strainBefore = 0.0; ///< largest p95 strain of a piece
  double strainAfter = 0.0;
  double rigidEnergyBefore = 0.0;
  double rigidEnergyAfter = 0.0;
  bool boundMet = false;
  Index trials = 0;
  std::vector<std::string> notes;
  Status status;
};

/// Proposes darts and seams for a surface that has some curves already, which stay as they are.
///
/// Each round takes the piece that is distorted most, ranks some thousand straight cuts by
/// ScaleFactor, flattens the best of them with the curves and options to come, moves the best about
/// while that helps, and keeps it; until every piece's strain is within the bound, the cuts or
/// their length are used up, or a cut gives too little for its price. Then cuts are taken back that
/// are not needed. The same for any number of threads.
CurveSuggestions suggestCurves(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SuggestionOptions& options, const Execution& execution = {});
}
