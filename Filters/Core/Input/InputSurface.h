// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Surface/SurfaceHealing.h"
#include "Surface/SurfacePreparation.h"
#include "Surface/TriangleMesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flattening
{
/// A line for the user: "12 triangles without area were taken out (first: 5, 88, 103)".
std::string describe(const Mending& mending);

/// Cells of an input as triangles over all of its points.
struct SurfaceTriangles
{
  Points3 points;
  Triangles triangles; ///< those of one cell in a row, cells in order
  std::vector<std::int64_t> cellOfTriangle;
  Status outcome;
};

/// The refusal of an input with more points or corners than half-edges can be counted with an
/// Index; Ok where it has not.
Status checkSize(std::int64_t points, std::int64_t corners);

/// A surface made into a mesh, or refused in the ids of the input.
struct LoadedSurface
{
  /// Once it is healed, the triangles of the mesh.
  SurfaceTriangles input;
  HealedSurface prepared;
  Status outcome;
  std::vector<std::string> mendings; ///< a sentence for each kind of defect, with cells as ids
};

LoadedSurface loadSurface(SurfaceTriangles input, CoincidentPoints coincident, Defects defects);

/// A body that cloth lies on.
struct LoadedBody
{
  TriangleMesh mesh;
  bool given = false;
  Status outcome;

  const TriangleMesh* get() const { return this->given ? &this->mesh : nullptr; }
};

/// One that is closed is turned so that its normals point outwards.
LoadedBody loadBody(SurfaceTriangles body);
}
