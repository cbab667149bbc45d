// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/SeamAllowance.h"
#include "Outlines/DrawingSource.h"

#include <unordered_map>

namespace flattening::pattern
{
/// Where a folded dart is drawn: as it lies, or with its tips drawn back, where a sewn dart is to
/// end before the cut does. Its legs go with them by the affine map that leaves the mouth where it
/// is, so that straight legs stay straight and mirror images stay mirror images, of equal lengths.
class DartPlacement
{
public:
  /// \param loop on which the dart lies
  DartPlacement(const DrawingSource& all, const Indices& loop, const Dart& dart);

  /// How far its tips are to be drawn back, millimetres.
  double back() const { return this->Back; }
  /// From the tip to the middle of the mouth or to the other tip, before.
  double depth() const { return this->Depth; }
  /// InvalidOption where the tips would be drawn back by more than half of the depth.
  Status check(const std::string& dart, const std::string& piece) const;
  /// Draws a leg, whose length is then the one it has in the plane.
  void place(PatternLine& leg) const;
  /// Where a point of the legs, or between them, is drawn.
  Point2 at(const Point2& point) const;

private:
  double Back = 0.0;
  double Depth = 0.0;
  Point2 Middle = Point2::Zero();  ///< of the mouth, or between the tips
  Point2 Mouth = Point2::Zero();   ///< a way along it
  Point2 Inwards = Point2::Zero(); ///< from the middle towards the tip, of length 1
  bool TwoTips = false;
};

/// The border of the cloth of one piece before its allowance: its loops, with the mouths of the
/// darts that are folded closed by their roofs.
class ClothOutline
{
public:
  /// The source stays the caller's and must outlive the outline.
  ClothOutline(const DrawingSource& all, std::size_t piece);

  /// The darts that are folded.
  const std::vector<Dart>& darts() const { return this->Darts; }
  /// Where a dart, by its place in darts(), is drawn.
  const DartPlacement& placement(std::size_t dart) const { return this->Placements[dart]; }
  /// That of the dart of which an edge of a loop is a leg; null where it is none that is folded.
  const DartPlacement* placementAlong(Index from, Index to) const;
  /// One polygon a loop but for the loops that are a folded dart, millimetres.
  std::vector<AllowancePolygon> polygons() const;

private:
  std::vector<Points2> glueTabs() const;
  AllowancePolygon polygonOf(std::size_t l) const;

  const DrawingSource& All;
  std::size_t Piece;
  const std::vector<Indices>& Loops;
  const std::vector<Dart>& Darts;
  std::vector<DartPlacement> Placements;
  std::unordered_map<std::uint64_t, std::size_t> Folded; ///< edges of the loops, with their darts
};
}
