// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PanelTriangles.h"

#include "Base/Types.h"
#include "Imprint/ConstrainedDelaunay.h"
#include "Outlines/PlaneGeometry.h"

namespace flattening
{
namespace pattern
{
bool triangulatePolygon(const Points2& polygon, Triangles& triangles, std::size_t& bad)
{
  constexpr double snap = 1e-9; // of the size
  const std::size_t count = polygon.size();
  Box box;
  for (const Point2& point : polygon)
  {
    box.add(point);
  }
  // A triangle around the polygon, within which its sides are drawn.
  const double size = 4.0 * box.extent().maxCoeff();
  const Point2 middle = (box.low + box.high) / 2.0;
  const Point2 a = middle + size * Point2(-2.0, -1.0);
  const Point2 b = middle + size * Point2(2.0, -1.0);
  const Point2 c = middle + size * Point2(0.0, 2.0);
  const auto lift = [](const Point2& q) { return Point3(q.x(), q.y(), 0.0); };
  ConstrainedDelaunay mesh(lift(a), lift(b), lift(c), snap * size);
  const double area = cross(b - a, c - a);
  Indices cornerOf(3, none);
  Indices vertices;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Point2& q = polygon[k];
    const double one = cross(c - b, q - b) / area;
    const double two = cross(a - c, q - c) / area;
    const Index vertex = mesh.addPoint({ one, two, 1.0 - one - two });
    if (static_cast<std::size_t>(vertex) != cornerOf.size())
    {
      bad = k;
      return false;
    }
    cornerOf.push_back(static_cast<Index>(k));
    vertices.push_back(vertex);
  }
  for (const bool drawn : { false, true })
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      const Index from = vertices[k];
      const Index to = vertices[(k + 1) % count];
      if (drawn ? mesh.chain(from, to).size() != 2 : !mesh.addSegment(from, to))
      {
        bad = k;
        return false;
      }
    }
  }
  if (mesh.vertexCount() != static_cast<Index>(cornerOf.size()))
  {
    bad = 0;
    return false;
  }
  Segments sides;
  addSegments(polygon, true, sides);
  triangles.clear();
  for (const Triangle& triangle : mesh.triangles())
  {
    Triangle corners{};
    Point2 centre = Point2::Zero();
    bool outside = false;
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = cornerOf[static_cast<std::size_t>(triangle[k])];
      outside = outside || corners[k] == none;
      centre += outside ? Point2(Point2::Zero())
                        : Point2(polygon[static_cast<std::size_t>(corners[k])] / 3.0);
    }
    if (!outside && inside(centre, sides))
    {
      triangles.push_back(corners);
    }
  }
  return true;
}
}
}
