// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ClosedMeshes.h"
#include "Flattened.h"
#include "Sewing/PieceSewing.h"
#include "TestMeshes.h"

namespace testmeshes
{
inline SewingResult sewn(
  const Surface& surface, const SewingOptions& options, const Execution& run = {})
{
  const FlatteningResult result = flatten(surface);
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
  Surface surface;
  surface.mesh = rolledUp(columns, rows, [=](double angle, double height) {
    const double radius = 1.0 + (upperRadius - 1.0) * height;
    return Point3(radius * std::cos(angle), radius * std::sin(angle), 2.0 * height);
  });
  for (const Index i : { Index(0), columns / 2 })
  {
    Indices vertices;
    for (Index j = 0; j <= rows; ++j)
    {
      vertices.push_back(j * columns + i);
    }
    surface.curves.push_back(curveOf(CurveType::Seam, "seam" + std::to_string(i), vertices));
  }
  return surface;
}

/// A patch that is no developable: the sheet has to give.
inline Surface dome()
{
  return cushion(12, 12, 0.2);
}
}
