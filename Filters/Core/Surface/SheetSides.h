// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

#include <vector>

namespace flattening
{
/// A closed part of a surface that is a sheet with thickness, as modellers give cloth, and CAD
/// programs walls.
struct ThickSheet
{
  Indices triangles;      ///< of both sides and the rim
  Indices outer;          ///< of the side with the larger area
  double thickness = 0.0; ///< mean
  /// Whether it bends by far more than it is thick, and has a rim all around: a thin plate or a
  /// cushion is not taken for cloth.
  bool isClear = false;
};

/// The thick sheets among the parts of a surface. The mean thickness is twice the volume over the
/// area. A triangle is of a side where other triangles are opposite to it at about this distance;
/// those without an opposite one are the rim, which separates the two sides.
std::vector<ThickSheet> thickSheets(const TriangleMesh& mesh);
}
