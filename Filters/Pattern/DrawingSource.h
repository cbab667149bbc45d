// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Darts.h"
#include "Notches.h"
#include "Pattern.h"
#include "PlaneGeometry.h"

namespace flattening
{
namespace pattern
{
class FairBorders;

/// What the drawing of each piece needs to know of the whole flattening.
struct DrawingSource
{
  const PatternSource& source;
  const PatternOptions& options;
  PieceLoops loops;
  SewnPartners partners;
  WireOfEdge wires;
  std::vector<NotchPlace> notches;
  const FairBorders* fair = nullptr; ///< null: borders are drawn as the mesh has them
  const Points2* moved = nullptr;    ///< where the points are then, millimetres

  /// How far points of an edge may be from its smooth curve, millimetres; 0: it stays as it is.
  double fairToleranceAlong(Index from, Index to) const;
  /// The name of the curve that an edge is of, or "boundary".
  std::string nameAlong(Index from, Index to) const;
  /// The value of a curve, the boundary's where an edge is of none, or the common one.
  double valueAlong(
    Index from, Index to, const std::map<std::string, double>& ofCurve, double common) const;
  /// Whether an edge is of a curve that lies on the fold of the cloth.
  bool isFoldEdge(Index from, Index to) const;
  double scale() const { return millimetresPer(this->options.unit); }
  Point2 at(Index point) const
  {
    return this->moved ? (*this->moved)[static_cast<std::size_t>(point)]
                       : Point2(this->scale() * this->source.positions[point]);
  }
  /// Adds the points of an edge of a border as it is drawn, all but its second end.
  void addAlong(Index from, Index to, Points2& points) const;
  /// A place on an edge of a border as it is drawn.
  /// \param outward to the right of the way from the first point to the second, of length 1
  Point2 onEdge(Index from, Index to, double fraction, Point2& outward) const;
};

/// Finds loops, partners, wires and notches of a source.
Status findBorders(DrawingSource& all);
}
}
