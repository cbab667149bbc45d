// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedSurface.h"
#include "Flattening/FlatteningResult.h"

#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkFieldData;

namespace flattening
{
namespace bridge
{
/// Writes what is known of the pieces, as vtkWireWarpingFilter documents its field data: measures
/// and statuses, what was done, iterations, what to release, and pieces that were left out.
void writePieceReports(
  const CurvedSurface& source, const FlatteningResult& result, vtkFieldData* field);

/// The ends of a cut along edges as points of the input; -1 where one has none there.
std::array<vtkIdType, 2> endsOf(
  const CurvedSurface& source, const FlatteningResult& result, const Indices& cut);

/// That the plane has no room for a piece, what would make some, and by which energy it is
/// flattened then; empty where it has.
std::string verdictOf(
  const CurvedSurface& source, const FlatteningResult& result, const PieceReport& piece);

/// A warning for each piece that the plane has no room for, or that was flattened by another energy
/// than the one asked for.
std::vector<std::string> describeVerdicts(
  const CurvedSurface& source, const FlatteningResult& result);
}
}
