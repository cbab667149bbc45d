// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FlatteningOutput.h"
#include "Reshaping/FlattenableSurface.h"

#include <set>

class vtkTable;

namespace flattening
{
namespace bridge
{
/// Finds the curves of these names; refuses a name that no curve has.
Status findCurves(const std::set<std::string>& names, const CurvedSurface& source, Indices& curves);

/// Writes the moved surface and its curves as vtkMakeFlattenable documents.
/// \param moved the source with its mesh moved
/// \param warnings get a sentence for each array of the curves that is left out
void writeMovedSurface(const CurvedSurface& source, const CurvedSurface& moved,
  const FlattenableSurface& result, vtkPolyData* surface, vtkPolyData* curves,
  std::vector<std::string>& warnings);

/// Writes the one row of the measures, and one row per flattening of the search.
void writeShiftMeasures(const FlattenableSurface& result, vtkTable* table);
void writeShiftTrials(const std::vector<FlattenableTrial>& trials, vtkTable* table);

/// A sentence that says how far the bound was missed, and what may help.
std::string describeShortfall(const FlattenableSurface& result, const FlattenableOptions& options);
}
}
