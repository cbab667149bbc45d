// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedSurface.h"

namespace flattening
{
namespace bridge
{
/// A sentence for each dart or seam that stops one edge short of the boundary, with the point of
/// the input to begin it at.
std::vector<std::string> describeShortEnds(const CurvedSurface& source);
}
}
