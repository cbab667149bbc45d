// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Darts.h"
#include "Outlines/Joins.h"
#include "Outlines/Notches.h"
#include "Outlines/Pattern.h"
#include "Outlines/PlaneGeometry.h"

#include <memory>

namespace flattening::pattern
{
class FairBorders;

/// "NAME:2" as a curve and a piece from 0; "NAME" and none where it does not end so.
std::pair<std::string, Index> curveSide(const std::string& text);

/// What the drawing of each piece needs to know of the whole flattening.
struct DrawingSource
{
  /// \param given cuts that were closed are taken for whole cloth
  DrawingSource(const PatternSource& given, PatternOptions asked);

  PatternSource source;
  PatternOptions options;
  PieceLoops loops;
  BorderEdges border;
  SewnPartners partners;
  WireOfEdge wires;
  std::vector<std::vector<Dart>> darts; ///< of each piece, that are folded
  std::vector<Join> joins;
  std::vector<std::vector<double>> stations; ///< of notches along each wire, from its start
  std::vector<NotchPlace> notches;
  std::shared_ptr<const FairBorders> fair; ///< null: borders are drawn as the mesh has them
  const Points2* moved = nullptr;          ///< where the points are then, millimetres

  /// How far points of an edge may be from its smooth curve, millimetres; 0: it stays as it is.
  double fairToleranceAlong(Index from, Index to) const;
  /// The name of the curve that an edge is of, or "boundary".
  std::string nameAlong(Index from, Index to) const;
  /// The value of a curve, the boundary's where an edge is of none, or the common one.
  double valueAlong(
    Index from, Index to, const std::map<std::string, double>& ofCurve, double common) const;
  /// The seam allowance of an edge of a border, millimetres.
  double allowanceAlong(Index from, Index to) const;
  /// Whether an edge is of a curve that lies on the fold of the cloth.
  bool isFoldEdge(Index from, Index to) const;
  double scale() const { return millimetresPer(this->options.unit); }
  Point2 at(Index point) const
  {
    return this->moved ? (*this->moved)[static_cast<std::size_t>(point)]
                       : Point2(this->scale() * this->source.positions[point]);
  }
  Points2 at(const Indices& points) const;
};

/// Finds loops, borders, partners, wires, darts, joins and notches of a source.
Status findBorders(DrawingSource& all);
}
