// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HostileCase.h"

namespace hostile
{
/// A sound surface of a shape that modellers make every day and grids never have: domes with a
/// pole, cones, fans, spirals, poked faces, strips one triangle wide, combs, stars, grids of any
/// aspect, parts refined by 10^4; valences from 3 to the number of triangles; half of them
/// renumbered at random.
Specimen makeOrdinarySurface(Bytes& bytes, const SizeRange& triangles);
}
