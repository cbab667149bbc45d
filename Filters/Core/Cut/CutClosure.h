// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"

#include <functional>
#include <optional>

namespace flattening
{
/// The two sides of a cut from its tip on.
struct CutSides
{
  Index tip = none; ///< a boundary vertex of the piece
  /// Boundary vertices that are one vertex of the surface: first the one before the tip along the
  /// boundary.
  std::vector<std::array<Index, 2>> pairs;
};

/// All cuts of a piece that end inside it or at a point of its boundary; one with two tips is found
/// from each.
std::vector<CutSides> findCutSides(const Piece& piece, const CutSurface& cut);

/// A piece some of whose vertices have become one.
struct JoinedPiece
{
  Piece piece;
  Indices place; ///< per vertex of the piece before, its vertex now
};

/// \param joined per vertex the one that it becomes, itself where it stays
JoinedPiece joinVertices(const Piece& piece, const Indices& joined);

/// Flattens the piece with vertices joined: per vertex the one that it becomes. \return positions
/// per vertex of the piece; none where it could not be flattened
using FlattenJoined = std::function<std::optional<Points2>(const Indices& joined)>;

/// Closes cuts where their sides overlap in the plane: where the surface is
/// saddle-like, opening a dart takes no cloth out but needs more of it than there is, and its sides
/// cross. Pairs of vertices that have crossed are joined, the piece is flattened anew, and so on
/// until none cross; a pair once joined stays so. The other vertices of the sides are free, so that
/// a dart may be closed at its mouth and open at its tip. \param positions of the piece with open
/// cuts
/// \return half-edges that lie on another one; empty where none cross, or closing does not help
Indices closeCuts(const Piece& piece, const CutSurface& cut, const Points2& positions,
  const FlattenJoined& flatten);
}
