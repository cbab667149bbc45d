// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <memory>

namespace flattening::pattern
{
/// Finds free places between shapes on a strip of cloth, x across it and y along it, on a grid of a
/// hundredth of a millimetre.
class NoFitRegion
{
public:
  NoFitRegion();
  ~NoFitRegion();
  NoFitRegion(const NoFitRegion&) = delete;
  NoFitRegion& operator=(const NoFitRegion&) = delete;

  /// Whether the build has Clipper, without which no place is found.
  static bool available();

  /// Adds a shape that is kept at a distance from others.
  /// \param polygon closed, within [0, width] x [0, height]
  /// \return its number, from 0
  std::size_t addShape(const Points2& polygon, double gap);

  struct Placed
  {
    std::size_t shape = 0;
    Point2 at = Point2::Zero();
  };
  /// The place with the least y, and of these with the least x, at which a shape is clear of those
  /// that lie there and within [0, width] of the strip.
  Point2 lowest(const std::vector<Placed>& there, std::size_t shape, double width) const;

private:
  struct Shapes;
  std::unique_ptr<Shapes> Known;
};
}
