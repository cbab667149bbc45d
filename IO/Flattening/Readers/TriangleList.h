// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace wirewarp
{
struct ListedTriangle
{
  std::array<std::int64_t, 3> corners;
  std::int64_t polygon = 0; ///< its place among the polygons of the input, whose data it has
};

/// The polygons of a surface as triangles that can be taken out, changed and added. Points and
/// their ids stay as they are, so that curves that name points keep their meaning.
struct TriangleList
{
  std::shared_ptr<const Points3> points;
  std::vector<ListedTriangle> triangles;

  const Point3& point(std::int64_t id) const
  {
    return (*this->points)[static_cast<std::size_t>(id)];
  }
};

/// Polygons and strips as the filters divide them. Empty where a cell names a point that does not
/// exist or has no finite place: such a surface is refused as it is.
TriangleList listTriangles(const DataSet& surface);

/// Around all triangles, and around points.
Eigen::AlignedBox3d boxOf(const TriangleList& list);
Eigen::AlignedBox3d boxOf(const Points3& points);

/// The surface with these triangles in place of its polygons; each has the data of the polygon that
/// it is from.
DataSet withTriangles(const DataSet& surface, const TriangleList& list);
}
