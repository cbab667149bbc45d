// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Cloth/ClothMeasures.h"
#include "Sewing/SewingModel.h"

namespace flattening
{
/// How far cloth at rest lies from the surface that was designed, and what it bears there.
struct SewnMeasures
{
  double size = 0.0; ///< root of the area of the design
  /// Of the vertices of the cloth from the designed surface, weighted by their area at rest.
  double distanceMean = 0.0;
  double distanceRms = 0.0;
  double distanceP95 = 0.0; ///< not exceeded on 95 % of the area
  /// Hausdorff distance: the largest of a vertex of one surface from the other surface.
  double distanceMax = 0.0;
  double normalDeviationMean = 0.0; ///< radians, by area at rest
  /// max |ln sigma| over both stretches of a triangle, by area at rest.
  double strainMean = 0.0;
  double strainP95 = 0.0;
  double strainMax = 0.0;
  /// Share of the area whose lesser stretch is below 1 - compressedBeyond: where it wrinkles.
  double compressedArea = 0.0;

  std::vector<double> distance;       ///< per vertex of the cloth, from the design
  std::vector<double> designDistance; ///< per vertex of the design, from the cloth
  /// Per triangle.
  std::vector<double> normalDeviation;          ///< radians
  std::vector<std::array<double, 2>> stretches; ///< the larger one first
};

/// What the threads of cloth at rest bear, weft along x and warp along y of the flat pieces.
struct SewnThreads
{
  std::vector<ThreadStrain> strains; ///< per triangle
  ClothSummary summary;              ///< means and shares by area at rest
};

/// A cloth that is shorter in one direction by this share folds rather than bears it.
inline constexpr double compressedBeyond = 1e-3;
inline bool isCompressed(const std::array<double, 2>& stretches)
{
  return stretches[1] < 1.0 - compressedBeyond;
}

/// \param cloth whose points are the design. \param points of the cloth at rest.
SewnMeasures measureSewn(const SewnCloth& cloth, const Points3& points, const Execution& execution);

SewnThreads measureSewnThreads(
  const SewnCloth& cloth, const Points3& points, const ClothMaterial& material);

/// Turns and moves a whole so that its vertices come nearest to those of the design, weighted by
/// their area at rest (W. Kabsch, "A solution for the best rotation to relate two sets of vectors",
/// Acta Crystallographica A32, 1976). A whole is never mirrored.
void alignToDesign(const SewnCloth& cloth, Points3& points);
}
