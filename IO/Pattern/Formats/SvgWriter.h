// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"

namespace flattening::pattern
{
/// A pattern as SVG 1.1 whose user unit is the millimetre, with a test rectangle of 100 mm x 50 mm.
/// One group a piece, in it one group a role, both layers to Inkscape; a wire's path has
/// `data-length`, its length on the surface, and `data-curve`. Written here and not with cairo,
/// whose paths are held in steps of a 256th of a point: lengths to 1e-6 need more digits than that.
/// \param laserColors a color a role, all lines thin and whole; otherwise as on paper
std::string makeSvg(const Pattern& pattern, bool laserColors);
}
