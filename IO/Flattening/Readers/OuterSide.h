// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TriangleList.h"

#include <optional>

namespace wirewarp
{
/// Of closed parts that are sheets with thickness keeps the outer side, as thickSheets() has it;
/// other parts stay as they are. \param clear only of those that clearly are
/// \return their mean thickness, none where there is no such sheet
std::optional<double> takeOuterSide(TriangleList& list, bool clear);
}
