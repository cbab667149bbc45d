// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TestMeshes.h"

#include <cmath>

namespace testmeshes
{
/// The part of the unit sphere within an angle of its pole, in rings of triangles of equal size,
/// with wires along diameters, the second across the first.
inline Surface sphereCap(double angle, Index rings, int wires)
{
  const auto at = [](Index ring, Index k) -> Index {
    return ring == 0 ? 0 : 1 + 2 * ring * (ring - 1) + k % (4 * ring);
  };
  Points3 points{ Point3(0.0, 0.0, 1.0) };
  Triangles triangles;
  for (Index ring = 1; ring <= rings; ++ring)
  {
    const double down = angle * ring / rings;
    for (Index k = 0; k < 4 * ring; ++k)
    {
      const double around = 2.0 * pi * k / (4 * ring);
      points.push_back(Point3(
        std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down)));
      const Index quarter = k / ring;
      const Index inner = k - quarter;
      triangles.push_back({ at(ring - 1, inner), at(ring, k), at(ring, k + 1) });
      if (k % ring != ring - 1)
      {
        triangles.push_back({ at(ring - 1, inner), at(ring, k + 1), at(ring - 1, inner + 1) });
      }
    }
  }
  Surface surface;
  surface.mesh = TriangleMesh(std::move(points), std::move(triangles));
  for (Index wire = 0; wire < wires; ++wire)
  {
    Indices vertices{ 0 };
    for (Index ring = 1; ring <= rings; ++ring)
    {
      vertices.insert(vertices.begin(), at(ring, wire * ring));
      vertices.push_back(at(ring, (wire + 2) * ring));
    }
    surface.curves.push_back(accessory("diameter" + std::to_string(wire), std::move(vertices)));
  }
  return surface;
}
}
