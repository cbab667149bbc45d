// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Editing/EditedCurve.h"
#include "Paths/PathGraph.h"
#include "Surface/SurfaceLocator.h"

namespace flattening
{
/// A surface to draw curves on, with what is made once for it.
class DrawingSurface
{
public:
  explicit DrawingSurface(TriangleMesh mesh);
  DrawingSurface(const DrawingSurface&) = delete;
  DrawingSurface& operator=(const DrawingSurface&) = delete;

  const TriangleMesh& mesh() const { return this->Mesh; }
  const PathGraph& graph() const { return this->Graph; }
  const SurfaceLocator& locator() const { return this->Locator; }
  const SnapDistance& snap() const { return this->Snap; }
  /// Boundary vertices where the boundary turns by more than 30 degrees.
  const Indices& corners() const { return this->Corners; }
  /// Half-edges of the boundary.
  const Indices& boundary() const { return this->Boundary; }

  /// The closest point of the surface.
  SurfacePoint pointNear(const Point3& point) const;
  /// The path through points of which each two neighbours lie in one triangle; none, not arrived,
  /// where some do not.
  SurfacePath pathThrough(const Points3& points) const;

private:
  TriangleMesh Mesh;
  PathGraph Graph;
  SurfaceLocator Locator;
  SnapDistance Snap;
  Indices Boundary;
  Indices Corners;
};
}
