// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Sewing/SewnMeasures.h"
#include "Sewing/SewnTopology.h"

#include <optional>

namespace flattening
{
struct SewingOptions
{
  SewingTest test = SewingTest::Panel;
  /// Stiffness of the cloth against changes of area and of angle, see evaluateIsotropicDensity().
  double areaBias = 0.0;
  /// Of a plate that bends as the cloth does, over the root of the mean area of a piece.
  double thickness = 1e-3;
  /// The cloth is at rest where no force on a vertex, over modulus times the root of the mean
  /// triangle area, is larger, ...
  double forceTolerance = 1e-12;
  /// ... or a further step promises to lower the energy by no more than this fraction of it.
  double energyTolerance = 1e-9;
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
