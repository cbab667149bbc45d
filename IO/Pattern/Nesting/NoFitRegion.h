// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <clipper.hpp>

#include <map>
#include <utility>
#include <vector>

namespace flattening::pattern
{
/// Finds free places between shapes on a strip of cloth, x across it and y along it, on a grid of a
/// hundredth of a millimetre.
class NoFitRegion
{
public:
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
  Point2 lowest(const std::vector<Placed>& there, std::size_t shape, double width);

private:
  struct Shape
  {
    ClipperLib::Path outline; ///< widened by half of the gap
    ClipperLib::cInt width = 0;
    ClipperLib::cInt height = 0;
  };

  const ClipperLib::Paths& between(std::size_t fixed, std::size_t moving);

  std::vector<Shape> Shapes;
  /// Where the second may not be while the first is at the origin.
  std::map<std::pair<std::size_t, std::size_t>, ClipperLib::Paths> NoFit;
};
}
