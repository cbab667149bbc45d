// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"
#include "Embedding/InteriorSystem.h"
#include "Quality/FlatteningQuality.h"
#include "Wires/WireNetwork.h"

#include <memory>
#include <optional>

namespace flattening
{
/// A piece and what follows from it and the place of its wires, each made when it is first asked
/// for.
struct WiredPiece
{
  Piece piece;
  std::optional<WireNetwork> network;
  InteriorSystems interiors;
  std::optional<SurfaceMeasures> measures;
};

/// What a run leaves for the next one: the cut surface and its pieces with their networks, measures
/// and factors. All of it is taken over where the surface, the edges of the curves and the choice
/// of those that are cut are the same as before; otherwise of the factors what still fits (see
/// InteriorSystem). The result is the same to the last bit as without.
struct FlatteningCache
{
  TriangleMesh mesh;       ///< the surface before the cut
  std::vector<char> opens; ///< by curve, as in CurveLabels
  std::shared_ptr<const CutSurface> cut;
  std::vector<WiredPiece> pieces;

  /// Whether cut and pieces are those of the surface with these curves.
  bool serves(const TriangleMesh& surface, const CurveLabels& labels) const;
  /// Cuts the surface anew. \param keep whether another run will ask serves().
  void renew(const TriangleMesh& surface, CurveLabels labels, bool keep);
};
}
