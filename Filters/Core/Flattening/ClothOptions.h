// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/ClothMaterial.h"

#include <vector>

namespace flattening
{
/// How a piece lies on its cloth.
enum class GrainKind
{
  Upright, ///< by the angle from the piece's upright
  Curve,   ///< by the angle from one of its curves
  Free,    ///< where the cloth is strained least
};

/// The cloth that pieces are cut from, and how.
struct ClothOptions
{
  ClothMaterial material;
  GrainKind grain = GrainKind::Upright;
  /// Curve: names; of each piece the first that lies in it, from its start to its end. A piece
  /// without any is laid by its upright, and its report says so.
  std::vector<std::string> grainCurves;
  /// Curve: one for each of them, from it to the warp, counter-clockwise in the plane, in radians.
  std::vector<double> grainAngles;
  /// The same from the upright, where that counts. Upright is the first key curve, else the long
  /// side of the smallest rectangle around the piece, as it lies without the material.
  double grainAngle = 0.0;
};
}
