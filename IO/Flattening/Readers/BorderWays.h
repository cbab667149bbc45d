// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BoundaryLoops.h"

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace wirewarp
{
/// Ways along the boundary of a surface.
class BorderWays
{
public:
  explicit BorderWays(const DataSet& surface);

  /// The points from each of some points on the boundary to the next, each time the shorter way
  /// round; of a point and itself the whole loop. Throws InputError where there is no such way.
  std::vector<std::int64_t> through(const std::vector<std::int64_t>& points) const;

  /// The nearer end of the edge of the boundary that is nearest to a place; -1 where there is no
  /// boundary. \param distance of the place from that edge
  std::int64_t nearest(const Point3& place, double& distance) const;

private:
  struct Place
  {
    std::size_t loop = 0;
    std::size_t at = 0;
    bool unique = true;
  };

  void add(std::int64_t from, std::int64_t to, std::vector<std::int64_t>& way) const;

  std::shared_ptr<const Points3> Points; ///< of the surface
  std::vector<BoundaryLoop> Loops;
  std::vector<std::vector<double>> Arc; ///< of the points of each loop, and its length
  std::unordered_map<std::int64_t, Place> Places;
};
}
