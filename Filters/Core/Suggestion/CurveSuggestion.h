// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Suggestion/CurveSuggestions.h"

namespace flattening
{
/// Proposes darts and seams for a surface that has some curves already, which stay as they are.
///
/// Each round takes the piece that is distorted most, ranks some thousand straight cuts by
/// ScaleFactor, flattens the best of them with the curves and options to come, moves the best about
/// while that helps, and keeps it; until every piece's strain is within the bound, the cuts or
/// their length are used up, or a cut gives too little for its price. Then cuts are taken back that
/// are not needed. So it is done by several goals and kinds of cuts, and the best set is taken. It
/// is never worse than no cuts; the search ends once the work is used up or the run cancelled. The
/// same for any number of threads. Cancelled only where the surface without cuts is not known yet.
///
/// Errors: InvalidOption (a number out of its range, a preference for an unknown curve, weights that
/// are none).
CurveSuggestions suggestCurves(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SuggestionOptions& options, const Execution& execution = {});
}
