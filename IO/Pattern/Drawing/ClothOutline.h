// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/DartPlacement.h"
#include "Drawing/SeamAllowance.h"

#include <unordered_map>

namespace flattening
{
namespace pattern
{
/// The border of the cloth of one piece before its allowance: its loops, with the mouths of the
/// darts that are folded closed by their roofs.
class ClothOutline
{
public:
  /// Source and loops stay the caller's and must outlive the outline.
  ClothOutline(const DrawingSource& all, const std::vector<Indices>& loops);

  /// The darts that are folded; none where the options want them cut out.
  const std::vector<Dart>& darts() const { return this->Darts; }
  /// Where a dart, by its place in darts(), is drawn.
  const DartPlacement& placement(std::size_t dart) const { return this->Placements[dart]; }
  /// That of the dart of which an edge of a loop is a leg; null where it is none that is folded.
  const DartPlacement* placementAlong(Index from, Index to) const;
  /// Whether an edge of a loop is a leg of a folded dart.
  bool isFolded(Index from, Index to) const;
  /// One polygon a loop but for the loops that are a folded dart, millimetres.
  std::vector<AllowancePolygon> polygons() const;
  /// Of an edge of a loop, millimetres.
  double allowanceOf(Index from, Index to) const;

private:
  AllowancePolygon polygonOf(std::size_t l) const;
  bool roof(std::size_t d, Point2& corner) const;

  const DrawingSource& All;
  const std::vector<Indices>& Loops;
  std::vector<Dart> Darts;
  std::vector<DartPlacement> Placements;
  std::unordered_map<std::uint64_t, std::size_t> Folded; ///< edges of the loops, with their darts
};
}
}
