// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BoundaryLoops.h"

#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <optional>
#include <string>
#include <unordered_map>

namespace wirewarp
{
/// Ways along the boundary of a surface.
class BorderWays
{
public:
  explicit BorderWays(vtkPolyData* surface);

  /// The points from each of some points on the boundary to the next, each time the shorter way
  /// round; of a point and itself the whole loop. None where there is no such way: then `fault`
  /// says why, and the way out.
  std::optional<std::vector<vtkIdType>> through(
    const std::vector<vtkIdType>& points, std::string& fault) const;

  /// The point of the boundary that is nearest to a place, -1 where there is no boundary.
  vtkIdType nearest(const double place[3], double& distance) const;

private:
  struct Place
  {
    std::size_t loop = 0;
    std::size_t at = 0;
    bool unique = true;
  };

  bool add(vtkIdType from, vtkIdType to, std::vector<vtkIdType>& way, std::string& fault) const;

  vtkSmartPointer<vtkPoints> Points; ///< of the surface
  std::vector<BoundaryLoop> Loops;
  std::vector<std::vector<double>> Arc; ///< of the points of each loop, and its length
  std::unordered_map<vtkIdType, Place> Places;
};
}
