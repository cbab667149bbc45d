// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedSurface.h"
#include "Suggestion/RegionWeights.h"

namespace flattening
{
namespace bridge
{
/// The weights of the surface's triangles in a cell array of the input. An empty name: none.
/// InvalidOption: there is no cell array of that name with one number for each cell.
Status readWeights(const CurvedSurface& source, const std::string& array, RegionWeights& weights);
}
}
