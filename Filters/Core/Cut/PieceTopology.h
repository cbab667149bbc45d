// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"

#include <optional>

namespace flattening
{
/// A piece that nothing can lay in the plane: it has no boundary, or it has handles.
struct PieceDefect
{
  Index triangle = none; ///< its first one, in the surface before the cut
  Index triangles = 0;   ///< how many it has
  bool closed = false;
  Index handles = 0;

  /// ClosedSurface or Handle.
  StatusCode code() const;
};

/// What keeps a piece out of the plane, if anything does.
std::optional<PieceDefect> findDefect(const Piece& piece);

/// Per piece the same.
std::vector<std::optional<PieceDefect>> findDefects(const std::vector<Piece>& pieces);

/// The refusal of a surface for all of its pieces that cannot be laid flat, in one message: Ok
/// where there is none, else ClosedSurface, or Handle where none is closed (ids: the first triangle
/// of each).
Status refusalOf(const std::vector<std::optional<PieceDefect>>& defects);

/// The cut surface without some of its pieces; see CutSurface::keptTriangles.
CutSurface withoutPieces(const CutSurface& cut, const std::vector<char>& leftOut);
}
