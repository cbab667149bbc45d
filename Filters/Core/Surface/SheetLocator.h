// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/SurfaceLocator.h"

#include <vector>

namespace flattening
{
/// Finds the points of a surface that are closest to those of lines. Where the surface touches
/// itself or another part, as at the two sides of a slit, there are several sheets, and a line
/// stays on the one on which it continues.
class SheetLocator
{
public:
  /// The mesh must outlive the locator.
  explicit SheetLocator(const TriangleMesh& mesh);

  /// Where one point of a line lies.
  struct Place
  {
    ClosestPoint closest;
    Indices sheet; ///< where there are several, the triangles there that lie on its own; ascending
  };
  /// By point. A point without a place has no triangle.
  std::vector<Place> along(const Points3& line) const;
  /// Of single points.
  const SurfaceLocator& points() const { return this->Locator; }

private:
  std::vector<std::vector<ClosestPoint>> sheetsAt(const Point3& point) const;

  const TriangleMesh& Mesh;
  SurfaceLocator Locator;
  double SamePlace;
  mutable Indices Parts; ///< by triangle, of what is joined; found when needed
};
}
