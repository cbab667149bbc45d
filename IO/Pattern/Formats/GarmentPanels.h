// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Garment.h"
#include "Outlines/PatternSource.h"

namespace flattening
{
namespace pattern
{
/// The panels that makePieces() made pieces of: vertices are where the points of the source are
/// now.
/// \param scale centimetres of its unit
/// \return InvalidPattern where checkGarment() does
Status garmentOf(const PatternSource& source, double scale, Garment& garment);
}
}
