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
/// Cells of an input as triangles over all of its points.
struct SurfaceTriangles
{
  Points3 points;
  Triangles triangles; ///< those of one cell in a row, cells in order
  std::vector<std::int64_t> cellOfTriangle;
  Status outcome;
};

/// Half-edges are counted with an Index.
constexpr std::int64_t mostTriangles = std::numeric_limits<Index>::max() / 3;

/// The refusal of an input with more points or corners than that; Ok where it has not.
Status checkSize(std::int64_t points, std::int64_t corners);

/// An id that does not fit stays out of range, for prepareSurface() to refuse.
Index pointIndex(std::int64_t id);

/// Appends the triangles of a polygon: the proposed ones where they cover it, else those of
/// triangulatePolygon().
/// \return whether there is one
bool appendPolygon(
  SurfaceTriangles& result, std::int64_t cell, const Indices& corners, const Triangles& proposed);

/// The refusal of polygons of which appendPolygon() made nothing; Ok where there is none.
Status refuseLost(const std::vector<std::int64_t>& cells);

/// What is done about defects of a surface.
enum class Defects
{
  Heal,      ///< where it is clear how, see healSurface()
  HealParts, ///< the same, but for specks
  Refuse,    ///< but for triangles that are turned over
};

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
