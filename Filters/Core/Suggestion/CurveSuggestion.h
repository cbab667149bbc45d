// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Suggestion/CurveSuggestions.h"

namespace flattening
{
/// Proposes darts and seams, or the lines of suggestLines(), for a surface that has some curves
/// already, which stay as they are.
///
/// For cuts each round takes the piece that is distorted most, ranks some thousand straight cuts by
/// ScaleFactor, flattens the best of them with the curves and options to come, moves the best about
/// while that helps, and keeps it; until every piece's strain is within the bound, the cuts or
/// their length are used up, or a cut gives too little for its price. Then cuts are taken back that
/// are not needed. So it is done in several ways; the sets that promise most are adjusted, see
/// adjustCuts(), and the best is proposed. The same for any number of threads.
CurveSuggestions suggestCurves(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SuggestionOptions& options, const Execution& execution = {});
}
