// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/SurfaceFlattening.h"
#include "Sewing/PieceSewing.h"
#include "TestMeshes.h"

namespace testmeshes
{
inline FlatteningResult flat(const Surface& surface)
{
  return flattenSurface(surface.mesh, surface.curves, {}, {});
}

inline SewingResult sewn(
  const Surface& surface, const SewingOptions& options, const Execution& run = {})
{
  const FlatteningResult result = flat(surface);
  return sewPieces(*result.cut, result.positions, options, run);
}

inline SewingOptions product(double thickness = 1e-3)
{
  SewingOptions options;
  options.test = SewingTest::Product;
  options.thickness = thickness;
  return options;
}

inline SewingOptions panel(double thickness = 1e-3)
{
  SewingOptions options;
  options.thickness = thickness;
  return options;
}

/// A frustum about the z axis (radius 1 below) with seams along two opposite rulings.
inline Surface frustum(Index columns, Index rows, double upperRadius)
{
  Points3 points;
  Triangles triangles;
  for (Index j = 0; j <= rows; ++j)
  {
    const double height = static_cast<double>(j) / rows;
    const double radius = 1.0 + (upperRadius - 1.0) * height;
    for (Index i = 0; i < columns; ++i)
    {
      const double angle = 2.0 * pi * i / columns;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 2.0 * height);
    }
  }
  const auto at = [columns](Index i, Index j) { return j * columns + i % columns; };
  for (Index j = 0; j < rows; ++j)
  {
    for (Index i = 0; i < columns; ++i)
    {
      triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  Surface surface;
  surface.mesh = TriangleMesh(std::move(points), std::move(triangles));
  for (const Index i : { Index(0), columns / 2 })
  {
    Indices vertices;
    for (Index j = 0; j <= rows; ++j)
    {
      vertices.push_back(at(i, j));
    }
    surface.curves.push_back(accessory("seam" + std::to_string(i), vertices));
    surface.curves.back().type = CurveType::Seam;
  }
  return surface;
}

/// A patch that is no developable: the sheet has to give.
inline Surface dome()
{
  return cushion(12, 12, 0.2);
}
}
