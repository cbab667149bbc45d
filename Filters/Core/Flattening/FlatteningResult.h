// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleSolution.h"
#include "Angles/ReleaseAdvice.h"
#include "Cloth/ClothEnergy.h"
#include "Cut/PieceTopology.h"
#include "Isometric/IsometricWarping.h"
#include "Quality/AreaForecast.h"
#include "Quality/BoundaryOverlap.h"
#include "Quality/FlatteningQuality.h"

#include <memory>
#include <optional>

namespace flattening
{
/// How a piece lies on its cloth, which has its warp along y.
struct GrainReport
{
  /// From the curve, or else from the upright of the piece (see ClothOptions), to the warp,
  /// counter-clockwise, in radians.
  double angle = 0.0;
  Index curve = none;
  /// The largest distance of that curve from the line between its ends, over its length.
  double bend = 0.0;
  bool missing = false; ///< none of the curves that were asked for lies in the piece
  Indices candidates;   ///< then those that could give it
};

struct ClothReport
{
  GrainReport grain;
  bool oneWay = false; ///< the material must not be turned by half a turn
  /// By how much the angle between the material's threads may change, in radians.
  double shearLimit = std::numeric_limits<double>::infinity();
  bool solved = false;  ///< the piece has the cloth's least energy; else it was only laid on it
  ClothSummary threads; ///< per triangle of the piece
  /// Where the limits are not met: triangles of the cut surface, the one farthest out first, and
  /// the wire that most of them lie along, which will not give way.
  Indices outOfLimit;
  Index limitingCurve = none;
  bool limitedByBoundary = false;
};

/// A wire in the result: a stretch of one feature curve, or a boundary loop.
struct Wire
{
  CurveType type = CurveType::Accessory;
  Index curve = none;    ///< none: boundary of the surface, or a connector
  bool boundary = false; ///< bounds its piece: so do the sides of a cut
  bool connector = false;
  Index piece = 0;
  Indices vertices;        ///< of the cut surface
  double restLength = 0.0; ///< on the surface
  double flatLength = 0.0;
  double maximumEdgeError = 0.0;  ///< largest EdgeLengthError::measured of one of its edges
  double resolvedEdgeError = 0.0; ///< largest EdgeLengthError::resolved
};

struct PieceReport
{
  Index triangles = 0;
  Index vertices = 0;
  Index wirePatches = 0;
  Index wireNodes = 0;
  Index freeWireNodes = 0;
  Index constraints = 0;
  int iterations = 0;
  /// Of Eq. 13, measured on the flat piece: half the sum of the squared changes of the wires'
  /// angles, whatever the scheme; nodes on key curves and around holes do not count.
  double objective = 0.0;
  /// Measured on the flat piece: the largest distance by which a loop of wires misses its start
  /// when its edges are laid one after the other with their lengths on the surface (elastic curves
  /// and connectors: in the plane) and the angles that they have in the plane.
  double closureResidual = 0.0;
  /// Isometric scheme: its energy's two terms, sheet and wire angles, in units of the mean triangle
  /// area.
  double distortionEnergy = 0.0;
  double angleEnergy = 0.0;
  QualitySummary quality;           ///< flipped: triangles of the cut surface
  std::optional<ClothReport> cloth; ///< where options have one
  /// On the surface, of darts and seams that bound or slit the piece, each once, without what is
  /// closed.
  double cutLength = 0.0;
  BoundaryOverlaps overlaps; ///< listed: half-edges of the cut surface
  /// Half-edges of the cut surface on sides of cuts that were closed (see closeCuts()).
  Indices closedEdges;
  /// What was done, which may be another thing than was asked for: then `fallbacks` says why.
  std::optional<AngleMethod> solverUsed;          ///< none in a conformal map
  std::optional<DistortionEnergyKind> energyUsed; ///< isometric scheme only
  /// Which energy that is and why, where another one was asked for.
  std::string otherEnergy;
  /// Whether the plane has room for the piece, known before it was flattened; its cuts in
  /// vertices of the cut surface.
  AreaForecast area;
  bool repaired = false; ///< progressive scheme: the angles did not close by themselves
  std::vector<std::string> fallbacks;
  std::vector<IterationRecord> history;             ///< of the wires' angles
  std::vector<IsometricIteration> isometricHistory; ///< isometric scheme: then of the whole piece
  Indices released;                                 ///< key curves whose shape was given up
  Index boundaryLoops = 1;
  bool wired = false; ///< a feature curve lies in it or bounds it
  /// Which curves to release first; with a trial where the wires' solution is poor.
  ReleaseAdvice advice;
  /// Progressive scheme: wire-patches (ids as in patchOfTriangle) in the order of warping.
  Indices warpingOrder;
  Status status;
};

struct CurveReport
{
  std::string name;
  CurveType type = CurveType::Accessory;
  /// Of all its wires; a cut curve counts once, and not where it runs on pieces that are left out.
  double restLength = 0.0;
  double flatLength = 0.0;
  double error = 0.0;     ///< largest relative error of one of its edges
  double tolerance = 0.0; ///< of an elastic curve; 0: rigid
  /// Of a cut: the length along which its sides were closed, on the surface.
  double closedLength = 0.0;
  /// dF* / d ln(length), summed over the pieces (see ReleaseAdvice).
  double sensitivity = 0.0;
  /// A key curve whose shape was given up, for ReleaseKeys or because it clashes with others.
  bool released = false;
};

struct StageSeconds
{
  double wires = 0.0;
  double interior = 0.0;
  double quality = 0.0;
  double total = 0.0;
};

struct FlatteningResult
{
  /// An error (then all else is empty), or Ok, or the worst warning of a piece.
  Status status;
  /// Never null. Shared with the cache, which makes another for another surface.
  std::shared_ptr<const CutSurface> cut = std::make_shared<const CutSurface>();
  Points2 positions;       ///< per vertex of the cut surface
  Indices patchOfTriangle; ///< wire-patch, numbered through all pieces
  std::vector<TriangleQuality> triangles;
  /// Per triangle, where options have a cloth.
  std::vector<ThreadStrain> threads;
  std::vector<double> developability; ///< per vertex of the cut surface, Eq. 25
  std::vector<Wire> wires;
  std::vector<PieceReport> pieces;
  /// Pieces that the cut surface and all of the above lack, because they cannot be laid flat.
  std::vector<PieceDefect> leftOut;
  std::vector<CurveReport> curves;
  StageSeconds seconds;
};
}
