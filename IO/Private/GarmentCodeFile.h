// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Garment.h"

namespace flattening
{
namespace bridge
{
/// Reads a file of GarmentCode: numbers in the unit that it states, brought to centimetres; edges
/// straight, quadratic, cubic or arcs of circles, also in the older form with one control point;
/// control points in the frame of their chord, or in that of the panel where the file says so. What
/// it does not know (parameters of a design) is passed over.
/// \return InvalidPattern with what is wrong where; NothingToDraw without a panel
Status readGarmentCode(const std::string& path, pattern::Garment& garment);
}
}
