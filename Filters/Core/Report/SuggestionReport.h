// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Columns.h"
#include "Input/CurvedSurface.h"
#include "Suggestion/CurveSuggestions.h"
#include "Surface/FeatureCurve.h"

#include <cstddef>
#include <string>
#include <vector>

namespace flattening
{
/// Curves of the input and then those proposed, a row each.
std::vector<SuggestedCurve> suggestionRows(
  const std::vector<Polyline>& curves, const CurveSuggestions& suggestions);

/// The arrays of vtkFeatureCurveSuggestion's curves. \param first row that is proposed
Columns suggestionArrays(const std::vector<SuggestedCurve>& rows, std::size_t first);

/// `MirrorAxis` or `MirrorPlane`; neither where nothing is mirrored.
Columns mirrorArrays(const CurveSuggestions& suggestions);

/// The lines that were tried and not proposed.
Columns leftOutTable(const CurveSuggestions& suggestions);

/// One row: how the search ended.
Columns searchTable(const CurveSuggestions& suggestions);

/// For a warning: how far the strain stays above the bound and where, that pieces fold or overlap,
/// or how wide one is, and what ended the search. Empty where both are kept, or there is none and
/// no limit of work ended the search.
/// \param curves of the input
std::string describeShortfall(const CurveSuggestions& suggestions, double bound,
  double maximumWidth, const std::vector<Polyline>& curves);
}
