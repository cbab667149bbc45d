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

/// The pieces of Data/ with all their curve sets; a piece with several sets comes once for each.
/// Empty where the folder cannot be read.
const std::vector<Specimen>& dataSpecimens();

/// A sound surface of a shape that modelers make every day and grids never have: domes with a pole,
/// cones, fans, spirals, poked faces, strips one triangle wide, combs, stars, grids of any aspect,
/// parts refined by 10^4; valences from 3 to the number of triangles; half of them renumbered at
/// random.
Specimen makeOrdinarySurface(Bytes& bytes, const SizeRange& triangles);

/// A surface to draw on: an ordinary one, one triangle, balls with poles and without, tori, tubes,
/// solids of few triangles, double pyramids with hubs, a needle; or two of these beside each other.
/// In units from 1e-6 to 1e6.
Specimen makeVariedSurface(std::mt19937& random);
}
