// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/SearchedPiece.h"

namespace flattening
{
/// Which part plans take with regard to the mirror plane of a piece, if it has one.
class MirrorRoles
{
public:
  /// The piece must outlive it. \param pairs whether cuts may come in pairs
  MirrorRoles(const SearchedPiece& piece, bool pairs);

  /// On which side of the plane; 0 in it. \pre there is one
  int side(const Point3& point) const;
  /// The boundary vertex nearest to a boundary vertex' image. \pre there is a plane
  Index mirroredBase(Index base) const;
  /// The role of a cut from one point to another; false where it can have none.
  bool take(const Point3& from, const Point3& to, CutPlan& plan) const;
  /// The same of a seam by its `via`, which it moves into the plane where that is near. \pre there
  /// is one
  bool takeOver(Index base, Index end, CutPlan& plan) const;
  /// Moves the ends of a plan that lies along the plane into it.
  void bringIntoPlane(CutPlan& plan) const;

private:
  BoundaryPlace inPlane(BoundaryPlace place) const;

  const SearchedPiece& Piece;
  bool Pairs;
  double Margin;
};
}
