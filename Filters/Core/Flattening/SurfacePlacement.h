// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningCache.h"
#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"
#include "Flattening/PieceFlattening.h"

namespace flattening
{
/// Lays the flat pieces beside each other where the options ask for it, and puts positions,
/// wire-patches, numbered through all pieces, and connectors into the result, whose other wires are
/// traced already. Takes the positions out of the flat pieces.
void placePieces(const std::vector<WiredPiece>& pieces, const FlatteningOptions& options,
  std::vector<FlatPiece>& flat, FlatteningResult& result);
}
