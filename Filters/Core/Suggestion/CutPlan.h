// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/BoundaryRuler.h"
#include "Surface/FeatureCurve.h"

#include <optional>

namespace flattening
{
/// How a plan stands to the mirror plane, or the axis of an intrinsic mirror.
enum class MirrorRole
{
  Alone, ///< there is no plane, or it is not kept
  Pair,  ///< comes with its mirror image
  Along, ///< lies in the plane
  Across ///< a seam from a point to its mirror image
};

/// A cut to be tried on a surface with a boundary: a straight line on it.
struct CutPlan
{
  CurveType type = CurveType::Dart;
  MirrorRole role = MirrorRole::Alone;
  BoundaryPlace base;          ///< the mouth of a dart, an end of a seam
  BoundaryPlace end;           ///< of a seam
  Point3 tip = Point3::Zero(); ///< of a dart
  std::optional<Point3> start; ///< of a dart inside, as at a waist: its other tip; it has no base
  std::optional<Point3> via;   ///< of a seam: where it runs over a peak; straight before and behind
  /// What its line would change, by ScaleFactor.
  double predictedGain = 0.0;
  double opening = 0.0;
  double length = 0.0; ///< along edges; with its mirror image
  double price = 0.0;

  double score() const { return this->predictedGain / this->price; }
};
}
