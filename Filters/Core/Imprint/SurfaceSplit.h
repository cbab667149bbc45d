// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/ImprintedSurface.h"
#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// A surface whose triangles were split along paths.
struct SplitSurface
{
  ImprintedSurface surface; ///< without curves
  /// Per path the vertices along it, from its first to its last point; one where all points met.
  std::vector<Indices> chains;
  /// Triangles whose parts would have no area, or that could not be split: a larger snap distance
  /// helps. Where there are any, there is no mesh.
  Indices failed;
};

/// Makes every path a chain of edges. The shape of the surface stays: new vertices lie on the edges
/// and inside the triangles of the mesh before, whose triangles keep their ids, the first part of
/// each the id of the whole.
SplitSurface splitSurface(
  const TriangleMesh& mesh, const SnapDistance& snap, const std::vector<SurfacePath>& paths);
}
