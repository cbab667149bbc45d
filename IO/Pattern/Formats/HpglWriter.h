// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"

namespace flattening::pattern
{
/// A pattern as HPGL for plotters and cutters, in their unit of a 40th of a millimetre, from the
/// lower left: pen 1 draws everything but the cut lines, with texts in 7 bits, then pen 2 cuts the
/// cut lines, holes first.
std::string makeHpgl(const Pattern& pattern);
}
