// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Suggestion/CurveSuggestions.h"

namespace flattening
{
/// Proposes center lines, grain lines, girths and style lines for a surface that has some curves
/// already, each with what it costs: the surface is flattened with it and all lines proposed before
/// it. Key curves are left out that break a promise, such as clash with others; accessory curves
/// also that raise the rigid energy by more than 5 %. The same for any number of threads.
CurveSuggestions suggestLines(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SuggestionOptions& options, const Execution& execution = {});
}
