// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/PieceTopology.h"
#include "Embedding/InteriorSystem.h"
#include "Quality/AreaForecast.h"
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
  bool disk = false; ///< known to have a boundary and no handles
  std::optional<WireNetwork> network;
  InteriorSystems interiors;
  std::optional<SurfaceMeasures> measures;
  std::optional<AreaForecast> area;
};

/// What a run leaves for the next one: the cut surface and its pieces with their networks, measures
/// and factors. All of it is taken over where the surface, the edges of the curves and the choice
/// of those that are cut are the same as before; otherwise of the factors what still fits (see
/// InteriorSystem). The result is the same to the last bit as without.
struct FlatteningCache
{
  TriangleMesh mesh;       ///< the surface before the cut
  std::vector<char> opens; ///< by curve, as in CurveLabels
  Indices curveOfHalfedge; ///< of the surface before the cut, where pieces were left out
  std::shared_ptr<const CutSurface> cut;
  std::vector<WiredPiece> pieces;
  /// The refusal for pieces that cannot be laid flat, or Ok where there are none, or they were left
  /// out.
  Status topology;
  std::vector<PieceDefect> leftOut;

  /// Whether cut and pieces are those of the surface with these curves. \param skip whether pieces
  /// that cannot be laid flat are to be left out.
  bool isValidFor(const TriangleMesh& surface, const CurveLabels& labels, bool skip) const;
  /// Cuts the surface anew. \param keep whether another run will ask isValidFor().
  void renew(const TriangleMesh& surface, CurveLabels labels, bool skip, bool keep);
};
}
