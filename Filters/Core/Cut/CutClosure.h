// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"

#include <functional>

namespace flattening
{
/// The two banks of a cut from its tip on.
struct CutBanks
{
  Index tip = none; ///< a boundary vertex of the piece
  /// Boundary vertices that are one vertex of the surface: first the one before the tip along the
  /// boundary.
  std::vector<std::array<Index, 2>> pairs;
};

/// All cuts of a piece that end inside it or at a point of its boundary; one with two tips is found
/// from each.
std::vector<CutBanks> findCutBanks(const Piece& piece, const CutSurface& cut);

/// A piece some of whose vertices have become one.
struct JoinedPiece
{
  Piece piece;
  Indices place; ///< per vertex of the piece before, its vertex now
};

/// \param joined per vertex the one that it becomes, itself where it stays
JoinedPiece joinVertices(const Piece& piece, const Indices& joined);

/// Cuts whose banks lie on each other.
struct CutClosure
{
  Indices joined; ///< per vertex the one that it lies on, itself where it is free
  Indices edges;  ///< half-edges of the banks that lie on another one
  Points2 positions;
  bool closed = false; ///< no cut's banks cross any more
};

/// Flattens a piece with some vertices joined. \return positions, empty where that failed.
using JoinedFlattening = std::function<Points2(const Indices& joined)>;

/// Closes cuts as far as their banks lie over each other in the plane: where the surface is
/// saddle-like, opening a dart takes no cloth out but asks for more of it than there is, and its
/// banks cross. Pairs of bank vertices that have crossed are joined, the piece is flattened anew,
/// and so on until none cross; a pair once joined stays so. The other vertices of the banks are
/// free, so that a dart may be closed at its mouth and open at its tip.
///
/// \param positions without anything joined
CutClosure closeCrossingCuts(
  const Piece& piece, const CutSurface& cut, Points2 positions, const JoinedFlattening& flatten);
}
