// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TriangleList.h"

#include <cstddef>
#include <optional>

namespace wirewarp
{
/// Of triangles with other points in the same places, as models of two-sided faces have them, keeps
/// one: that of the part with the first point.
/// \return how many were taken out
std::size_t takeOneOfTwoFaces(TriangleList& list);

/// Of closed parts that are sheets with thickness keeps the outer side, as thickSheets() has it;
/// other parts stay as they are. \param clear only of those that clearly are
/// \return their mean thickness, none where there is no such sheet
std::optional<double> takeOuterSide(TriangleList& list, bool clear);
}
