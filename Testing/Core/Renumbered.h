// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TestMeshes.h"

namespace testmeshes
{
/// The same surface with vertex v as place[v].
inline Surface withVertices(const Surface& surface, const Indices& place)
{
  Points3 points(place.size());
  for (std::size_t v = 0; v < place.size(); ++v)
  {
    points[place[v]] = surface.mesh.point(static_cast<Index>(v));
  }
  Triangles triangles = surface.mesh.triangles();
  for (Triangle& triangle : triangles)
  {
    triangle = { place[triangle[0]], place[triangle[1]], place[triangle[2]] };
  }
  Surface result = surface;
  result.mesh = TriangleMesh(std::move(points), std::move(triangles));
  for (FeatureCurve& curve : result.curves)
  {
    for (Index& v : curve.vertices)
    {
      v = place[v];
    }
  }
  return result;
}

/// The same surface with vertices and triangles in another order and other first corners;
/// `place[v]` is where vertex v went.
inline Surface renumbered(const Surface& surface, std::mt19937& random, Indices& place)
{
  place.resize(surface.mesh.vertexCount());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  Surface result = withVertices(surface, place);
  Triangles triangles = result.mesh.triangles();
  std::shuffle(triangles.begin(), triangles.end(), random);
  for (Triangle& triangle : triangles)
  {
    std::rotate(triangle.begin(), triangle.begin() + random() % 3, triangle.end());
  }
  result.mesh = TriangleMesh(result.mesh.points(), std::move(triangles));
  for (FeatureCurve& curve : result.curves)
  {
    std::reverse(curve.vertices.begin(), curve.vertices.end());
  }
  return result;
}
}
