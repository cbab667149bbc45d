// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CurveSuggestion.h"

#include "vtkSmartPointer.h"

class vtkPolyData;
class vtkTable;

namespace flattening
{
namespace bridge
{
/// Curves and then proposed cuts as polylines with points of their own; the arrays are those of
/// vtkFeatureCurveSuggestion.
void writeSuggestions(
  const std::vector<Polyline>& curves, const CurveSuggestions& suggestions, vtkPolyData* output);

/// The lines that were tried and not proposed.
vtkSmartPointer<vtkTable> leftOutLines(const CurveSuggestions& suggestions);

/// Writes one row: how the search ended.
void writeSearch(const CurveSuggestions& suggestions, vtkTable* table);

/// For a warning: how far the strain stays above the bound and where, and what ended the search.
/// Empty where the bound is met, or there is none and no limit of work ended the search.
/// \param curves of the input
std::string describeShortfall(
  const CurveSuggestions& suggestions, double bound, const std::vector<Polyline>& curves);
}
}
