// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pattern.h"

namespace flattening
{
namespace pattern
{
/// A pattern as SVG 1.1 whose user unit is the millimetre, with a test rectangle of 100 mm x 50 mm.
/// One group a piece, in it one group a kind of line; a wire's path has `data-length`, its length
/// on the surface, and `data-curve`. Written here and not with cairo, whose paths are held in steps
/// of a 256th of a point: lengths to 1e-6 need more digits than that.
std::string makeSvg(const Pattern& pattern);
}
}
