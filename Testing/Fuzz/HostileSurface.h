// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HostileCase.h"

namespace hostile
{
/// A part of a specimen, or a surface made by formula: sheets, tubes, spheres, a torus, a one-sided
/// band, a few arbitrary triangles.
Specimen makeSurface(
  Bytes& bytes, const std::vector<Specimen>& specimens, const SizeRange& triangles);

/// Drops, doubles and flips triangles, merges, moves and breaks points.
void mutateSurface(Bytes& bytes, Specimen& surface);

/// Numbers the points anew in the order in which triangles use them, and leaves out the others.
void keepUsedPoints(Specimen& surface);

/// Each triangle becomes four.
void refineSurface(Specimen& surface);
}
