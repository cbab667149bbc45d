// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Cloth/ClothEnergy.h"
#include "Sewing/SewingModel.h"

#include <optional>

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

struct SewingOptions
{
  SewingTest test = SewingTest::Panel;
  /// Stiffness of the cloth against changes of area and of angle, see evaluateIsotropicDensity().
  double areaBias = 0.0;
  /// Of a plate that bends as the cloth does, over the root of the mean area of a piece.
  double thickness = 1e-3;
  int maximumIterations = 300;
  /// Behind the cloth, along the normals of the design, times the root of the design's area over
  /// modulus. Product: what is sewn together must be closed.
  double pressure = 0.0;
  /// Weight of the cloth per area, times the root of the design's area over modulus. Product: it
  /// must have a body to lie on.
  Point3 gravity = Point3::Zero();
  /// What the cloth is made of, with its warp along y of the flat pieces; the modulus is that of
  /// the stiffer thread. Without one, and of an isotropic one, the isotropic sheet.
  std::optional<ClothMaterial> material;
  /// A surface that the cloth does not go through, its normals outwards; null: none.
  const TriangleMesh* body = nullptr;
  double gap = 1e-3; ///< that it keeps from the cloth, over the root of the mean area of a piece
  /// Come to rest from a second start as well, on the other side of the design, to learn of other
  /// shapes.
  bool secondStart = true;
};

/// One iteration of a shape.
struct SewingIteration
{
  double energy = 0.0; ///< in mean triangle areas times half the modulus
  double force = 0.0;  ///< largest, over modulus times the root of the mean triangle area
  double move = 0.0;   ///< of the vertex that moved farthest, in roots of the mean triangle area
  bool exact = false;  ///< the exact Hessian, or its convex part
};

/// What became of pieces that hang together.
struct SewnReport
{
  Index pieces = 0;
  Index triangles = 0;
  int iterations = 0;
  bool converged = false;
  double membraneEnergy = 0.0; ///< over half the modulus, unit of length squared
  double bendingEnergy = 0.0;  ///< the same
  /// How deep a vertex that is not held lies in the body; 0: none does.
  double bodyDepth = 0.0;
  /// From a start that is shaken by a thousandth of the size: its mean distance from the design.
  double secondDistance = 0.0;
  bool severalShapes = false; ///< the two differ by more than a tenth
  SewnMeasures measures;
  std::optional<SewnThreads> threads; ///< of a material with threads
  std::vector<SewingIteration> history;
  Status status;
};

struct SewingResult
{
  Status status; ///< a refusal, or Ok, or NotConverged
  std::vector<SewnReport> shapes;
  Indices shapeOfTriangle; ///< per triangle of the cut surface
  Points3 points;          ///< per vertex of the cut surface: where it lies at rest
  /// Per vertex of the cut surface: from there to the design, and from the design to the cloth.
  std::vector<double> distance;
  std::vector<double> designDistance;
  /// Per triangle of the cut surface.
  std::vector<double> normalDeviation;          ///< radians
  std::vector<std::array<double, 2>> stretches; ///< the larger one first
  std::vector<ThreadStrain> threads;            ///< of a material with threads
  /// Per pair of the cut surface's seams: the length of the edge at rest in space over that in the
  /// plane less 1, of both sides.
  std::vector<std::array<double, 2>> seamStrain;
};

/// Sews flat pieces together again and lets them come to rest: least energy of stretching and
/// bending by Newton's method, from the design on. Without friction; under pressure, by its weight
/// and on a body where these are given.
/// \param cut the designed surface, cut open. \param positions in the plane, per vertex of it.
/// Errors: InvalidOption (an option out of its range; Product: a piece that is sewn to nothing,
/// ids: a triangle of each; pressure in a product that is open, gravity on one without a body),
/// EmptySurface, DegenerateTriangle
/// (flat pieces without area), Cancelled, OutOfMemory. Warning: NotConverged.
SewingResult sewPieces(const CutSurface& cut, const Points2& positions,
  const SewingOptions& options, const Execution& execution);
}
