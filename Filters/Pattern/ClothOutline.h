// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DrawingSource.h"
#include "SeamAllowance.h"

#include <unordered_set>

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
  /// Whether an edge of a loop is a leg of a folded dart.
  bool isFolded(Index from, Index to) const;
  /// One polygon a loop but for the loops that are a folded dart, millimetres.
  std::vector<AllowancePolygon> polygons() const;

private:
  double allowanceOf(Index from, Index to) const;
  AllowancePolygon polygonOf(std::size_t l) const;
  bool roof(const Dart& dart, Point2& corner) const;

  const DrawingSource& All;
  const std::vector<Indices>& Loops;
  std::vector<Dart> Darts;
  std::unordered_set<std::uint64_t> Folded;
};
}
}
