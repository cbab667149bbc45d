// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/DrawingSource.h"
#include "Outlines/Pattern.h"

#include <optional>
#include <set>
#include <string>

namespace flattening::pattern
{
class FairCache;

/// Errors: InvalidOption where a curve is named that is not there, or no line is smooth that is to
/// be symmetric. Ranges are those of Formats/PatternOptionTable, which makePatternFile() checks.
Status checkPatternOptions(const PatternSource& source, const PatternOptions& options);

/// The names of all curves that have an option of their own, with sides as "NAME:2".
std::set<std::string> curvesWithOptions(const PatternOptions& options);

/// Checks a flattening and how it is to be drawn, and finds what all drawings of it need.
/// \param cache of smooth borders, for other files of the same flattening; null: none
/// \param all there where the outcome is good
/// \pre options are within their ranges
Status prepareDrawing(const PatternSource& source, const PatternOptions& given, FairCache* cache,
  std::optional<DrawingSource>& all);

/// Draws a flattening as a pattern to cut at true scale. The lines that are wires have their points
/// exactly where the flattening has them, scaled to millimetres and moved, or are smooth.
/// \param all as prepareDrawing() gives it
Status buildPattern(const DrawingSource& all, Pattern& pattern);
}
