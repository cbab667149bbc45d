// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"

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

/// Closes cuts as far as their banks lie over each other in the plane: where the surface is
/// saddle-like, opening a dart takes no cloth out but asks for more of it than there is, and its
/// banks cross. Pairs of bank vertices that have crossed are joined, the piece is flattened anew,
/// and so on until none cross; a pair once joined stays so. The other vertices of the banks are
/// free, so that a dart may be closed at its mouth and open at its tip.
///
/// It flattens nothing itself: it asks for a flattening and is given the positions.
///
///     CutClosing closing(piece, cut);
///     const Indices* joined = closing.next(&positions);
///     while (joined)
///     {
///       ... flatten the piece with these vertices joined ...
///       joined = closing.next(good ? &positions : nullptr);
///     }
class CutClosing
{
public:
  CutClosing(const Piece& piece, const CutSurface& cut);

  /// \param positions per vertex of the piece, with what was asked for joined; null where that could
  /// not be flattened. \return per vertex the one to join it with, itself where it stays free; null
  /// when there is nothing more to do
  const Indices* next(const Points2* positions);

  /// After the last step: no cut's banks cross any more.
  bool closed() const { return this->Closed; }
  /// Half-edges of the banks that lie on another one.
  Indices closedEdges() const;

private:
  using Pairs = std::vector<std::array<Index, 2>>;

  std::vector<char> crossingVertices(const Points2& positions) const;
  double gap(const Points2& positions, const CutBanks& cut, std::size_t k) const;
  bool takesPart(const CutBanks& cut) const;
  Pairs crossedPairs(const Points2& positions) const;
  Pairs crossingPairs() const;
  Pairs wholeCuts() const;
  bool joinPair(const std::array<Index, 2>& pair);
  bool join(const Pairs& pairs);
  bool joinNextToLonePairs();
  void findCutsAnew();

  const Piece& Subject;
  const CutSurface& Cut;
  std::vector<CutBanks> Cuts; ///< with what is joined left out
  Indices Joined;
  Indices NextJoined;         ///< per vertex the next one of those joined with it, in a ring
  std::vector<char> Crossing; ///< vertices on boundary edges that cross
  bool Closed = false;
};
}
