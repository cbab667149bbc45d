// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FlatteningOutput.h"
#include "Reshaping/FlattenableSurface.h"

#include <array>
#include <set>

namespace flattening
{
namespace bridge
{
/// Finds the curves of these names; refuses a name that no curve has.
Status findCurves(const std::set<std::string>& names, const CurvedSurface& source, Indices& curves);

/// Writes what vtkMakeFlattenable documents. \param outputs its ports.
/// \param warnings get a sentence for each array of the curves that is left out.
void writeFlattenable(const CurvedSurface& source, const FlattenableSurface& result,
  const std::array<vtkPolyData*, 6>& outputs, std::vector<std::string>& warnings);

/// A sentence that says how far the bound was missed, and what may help.
std::string describeShortfall(const FlattenableSurface& result, const FlattenableOptions& options);
}
}
