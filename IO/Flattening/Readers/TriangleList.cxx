// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleList.h"

#include "Surface/SurfacePreparation.h"

#include <algorithm>
#include <numeric>

namespace wirewarp
{
TriangleList listTriangles(const DataSet& surface)
{
  TriangleList list;
  list.points = surface.points;
  const flattening::SurfaceTriangles read = flattening::readTriangles(surface);
  const auto exists = [&read](flattening::Index p) {
    return p >= 0 && p < static_cast<flattening::Index>(read.points.size()) &&
      flattening::isUsable(read.points[static_cast<std::size_t>(p)]);
  };
  for (std::size_t t = 0; t < read.triangles.size(); ++t)
  {
    const flattening::Triangle& corners = read.triangles[t];
    if (!std::all_of(corners.begin(), corners.end(), exists))
    {
      return { surface.points, {} };
    }
    list.triangles.push_back({ { corners[0], corners[1], corners[2] },
      read.cellOfTriangle[t] - static_cast<std::int64_t>(surface.firstFace()) });
  }
  return list;
}

Eigen::AlignedBox3d boxOf(const TriangleList& list)
{
  Eigen::AlignedBox3d box;
  for (const ListedTriangle& triangle : list.triangles)
  {
    for (const std::int64_t corner : triangle.corners)
    {
      box.extend(list.point(corner));
    }
  }
  return box;
}

Eigen::AlignedBox3d boxOf(const Points3& points)
{
  Eigen::AlignedBox3d box;
  for (const Point3& point : points)
  {
    box.extend(point);
  }
  return box;
}

DataSet withTriangles(const DataSet& surface, const TriangleList& list)
{
  DataSet result = surface;
  result.faces = {};
  result.strips = {};
  std::vector<std::int64_t> rows(surface.firstFace());
  std::iota(rows.begin(), rows.end(), std::int64_t{ 0 });
  for (const ListedTriangle& triangle : list.triangles)
  {
    result.faces.add(triangle.corners);
    rows.push_back(static_cast<std::int64_t>(surface.firstFace()) + triangle.polygon);
  }
  result.cellArrays = flattening::copiedRows(surface.cellArrays, rows);
  return result;
}
}
