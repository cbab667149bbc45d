// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Columns.h"
#include "Input/CurvedSurface.h"
#include "Reshaping/FlattenableSurface.h"

#include <set>
#include <string>
#include <vector>

namespace flattening
{
/// `Shift`, `ShiftDistance`, `ShiftOutwards` and `Kept` of the vertices.
Columns shiftArrays(const TriangleMesh& design, const FlattenableSurface& result);

/// The one row of the measures.
Columns shiftTable(const FlattenableSurface& result);

/// One row per flattening of the search.
Columns shiftTrialTable(const std::vector<FlattenableTrial>& trials);

/// Finds the curves of these names; refuses a name that no curve has.
Status findCurves(const std::set<std::string>& names, const CurvedSurface& source, Indices& curves);

/// A sentence that says how far the bound was missed, and what may help.
std::string describeShortfall(const FlattenableSurface& result, const FlattenableOptions& options);
}
