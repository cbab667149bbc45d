// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfaceTrace.h"
#include "Paths/PathDistance.h"

#include <array>
#include <cstdint>
#include <map>

namespace flattening
{
/// The legs of a path by cells of space, so that whoever asks for feet of many points looks only at
/// those legs that are near. Gives the feet that pathFeet() gives, bit for bit.
class NearbyLegs
{
public:
  /// The path must outlive it.
  /// \param bound the greatest that feet() is asked for
  NearbyLegs(const SurfacePath& path, double bound);

  /// Errors of the caller: a bound greater than that of the constructor finds too few.
  std::vector<PathFoot> feet(const Point3& point, double bound) const;

private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cellOf(const Point3& point) const;

  const SurfacePath& Path;
  double Size = 0.0; ///< of a cell
  std::map<Cell, std::vector<std::size_t>> Legs;
};
}
