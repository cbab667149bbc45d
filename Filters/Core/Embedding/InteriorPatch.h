// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Wires/WireNetwork.h"

namespace flattening
{
/// The part of a wire-patch that its interior vertices take part in, in ids of its own: the first
/// freeCount vertices are interior, the others stand on wires.
struct InteriorPatch
{
  Index patch = none;
  Index freeCount = 0;
  /// Piece vertex of each, first the interior ones, then all of the wire-patch's wires, ascending.
  Indices vertices;
  Triangles triangles; ///< those with an interior corner
};

/// The wire-patches that have interior vertices.
std::vector<InteriorPatch> collectInteriorPatches(const Piece& piece, const WireNetwork& network);

/// The same with only those of the interior vertices free that are marked; the others beside them
/// are held like those on wires.
/// \param marked per vertex of the patch.
InteriorPatch restrictedTo(const InteriorPatch& patch, const std::vector<char>& marked);
}
