// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"

namespace flattening
{
struct FlattenableOptions
{
  /// The strain, on 95 % of each piece's area, that is good enough.
  double bound = 0.02;
  /// Whether the boundary of the surface stays where it is.
  bool keepBoundary = true;
  Indices kept; ///< curves that do
  /// Moving inwards costs 1 / (1 - outsideBias) times what moving outwards costs, along the normals
  /// of the design; at 1 no vertex moves inwards. 0 to 1.
  double outsideBias = 0.0;
  /// Of a plate that bends as the cloth does, over the root of the area of what is sewn together.
  double thickness = 1e-3;
  /// A surface that is not entered, its normals outwards; null: none. What of the design lies
  /// inside goes no deeper.
  const TriangleMesh* body = nullptr;
  FlatteningOptions flattening;
};

/// One flattening of the search.
struct FlattenableTrial
{
  double anchor = 0.0; ///< see DesignAnchor; the last one that was set
  double share = 1.0;  ///< of the way from the design
  double strain = 0.0; ///< largest of a piece, on 95 % of its area
  double shift = 0.0;  ///< mean, over the root of the area
};

/// How far a surface lies from its design, vertex from vertex, by area.
struct SurfaceShift
{
  double size = 0.0; ///< root of the area of the design
  double mean = 0.0;
  double p95 = 0.0; ///< not exceeded on 95 % of the area
  double max = 0.0;
  std::vector<double> ofVertex;
  /// Of that, along the normals of the design; below 0 inwards. Mean, most, and of each vertex.
  double outwardsMean = 0.0;
  double inwardsMax = 0.0; ///< not below 0
  std::vector<double> outwardsOfVertex;
};

struct FlattenableSurface
{
  /// A refusal (then all else is empty), or that of the flattening afterwards.
  Status status;
  TriangleMesh mesh; ///< the moved surface, with the vertices and triangles of the design
  bool boundMet = false;
  /// What ended the search short of the bound, and what was not free to move; empty: it is met.
  std::string hindrance;
  double strainBefore = 0.0; ///< largest of a piece, on 95 % of its area
  double strainAfter = 0.0;
  SurfaceShift shift;
  std::vector<char> kept; ///< per vertex: it was not to be moved
  FlatteningResult before;
  FlatteningResult after;
  std::vector<FlattenableTrial> trials;
};

/// Moves a surface as little as it finds enough for its flat pieces to be strained by no more than
/// the bound.
///
/// The surface is flattened and sewn together again in turn, the cloth being drawn back to the
/// design by springs that are weakened until the bound holds; then they are strengthened again and
/// the surface goes back towards the design while it holds (block descent on shift plus strain
/// energy; the aim is that of C. C. L. Wang, "Towards flattenable mesh surfaces", Computer-Aided
/// Design 40(1), 2008, with a bound on the strain instead of angles that sum to 2 pi). Under the
/// weakest springs it goes on for as long as that lowers the strain; where it does not, it starts
/// again as a thicker plate, which takes wrinkles out. What is kept does not move at all. The same
/// for any number of threads.
///
/// A bound that is not met is no refusal: the result is then the surface with the least strain that
/// was found.
/// Errors: InvalidOption (bound outside (0, 1), thickness or bias outside 0..1, a curve that there
/// is not), and those of flattenSurface().
FlattenableSurface makeFlattenable(const TriangleMesh& mesh,
  const std::vector<FeatureCurve>& curves, const FlattenableOptions& options,
  const Execution& execution);
}
