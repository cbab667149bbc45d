// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceScheme.h"

#include "Base/Stopwatch.h"
#include "Embedding/ConvexEmbedding.h"
#include "Embedding/LeastSquaresConformalMap.h"
#include "Flattening/ClothPlacement.h"
#include "Flattening/PieceWarping.h"
#include "Flattening/PieceWires.h"
#include "Quality/FlatteningQuality.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// Larger tubes are only mapped: warping one takes minutes, and nothing can be cut by the result.
constexpr Index maximumTubeTriangles = 20000;

/// The least squares conformal map of the piece.
void mapPiece(const PieceContext& context, PieceSolution& solution)
{
  LeastSquaresConformalOptions conformal = context.options.conformal;
  for (Index& pin : conformal.pins)
  {
    // The first copy of the pinned vertex in this piece.
    const Indices& vertices = context.piece.vertices;
    const auto copy = std::find_if(vertices.begin(), vertices.end(),
      [&](Index v) { return pin != none && context.cut.originalVertex[v] == pin; });
    pin = copy == vertices.end() ? none : static_cast<Index>(copy - vertices.begin());
  }
  if (conformal.pins[0] == none || conformal.pins[1] == none)
  {
    conformal.pins = { none, none };
  }
  LeastSquaresConformalMap map =
    leastSquaresConformalMap(context.piece.mesh, conformal, context.execution);
  solution.positions = std::move(map.positions);
  solution.placement = std::move(map.status);
}

PieceSolution flattenConformally(const PieceContext& context)
{
  Stopwatch watch;
  PieceSolution piece;
  // The map holds no wire, but what it does to them is measured.
  piece.problem = makeAngleProblem(context.network, freeNodes(context.network));
  mapPiece(context, piece);
  layOnCloth(context, piece);
  piece.status = piece.placement;
  piece.secondsInterior = watch.seconds();
  return piece;
}

/// A tube without its lengths. Without a value where it cannot be mapped or the run was cancelled.
std::optional<PieceSolution> mapTube(const PieceContext& context, const PieceSolution& wires)
{
  PieceSolution piece = wires;
  piece.positions = embedConvexly(context.piece.mesh, context.execution);
  if (piece.positions.empty())
  {
    return std::nullopt;
  }
  piece.status = { StatusCode::NotConverged,
    "the piece is a tube, which no plane can hold; with " +
      std::to_string(context.piece.mesh.triangleCount()) +
      " triangles it is only mapped, without its lengths",
    {}, {} };
  layOnCloth(context, piece);
  return piece;
}

/// A piece for which the plane has no room, from a convex embedding at once: placed by its wires'
/// angles it would fold, and untangling it would take long and help little. Without a value where
/// that does not keep what was asked for.
std::optional<PieceSolution> flattenDeepPiece(
  const PieceContext& context, const PieceSolution& wires)
{
  if (!context.exceedsPlanarArea() || context.options.scheme != Scheme::Isometric ||
    wires.status.refused())
  {
    return std::nullopt;
  }
  context.execution.report(0.1, "Flattening a piece that no plane can hold");
  if (context.area->tube() && context.piece.mesh.triangleCount() > maximumTubeTriangles)
  {
    return mapTube(context, wires);
  }
  std::optional<PieceSolution> piece =
    warpFromConvexStart(context, wires, context.options.isometric);
  const bool good = piece && (piece->placement.ok() || !wires.locks()) &&
    countFlipped(context.piece.mesh, piece->positions) == 0;
  if (!good)
  {
    return std::nullopt;
  }
  layOnCloth(context, *piece);
  if (piece->status.code == StatusCode::NotConverged)
  {
    piece->status = {}; // of angles that were not used
  }
  noteStatus(piece->placement, piece->status);
  return piece;
}

/// With a free boundary the wires have no angles to start from. Without a value where the piece
/// has no map without a fold.
std::optional<PieceSolution> flattenFreely(const PieceContext& context, const CurveRules& rules)
{
  PieceSolution wires;
  wires.rules = rules;
  if (context.options.releaseKeys)
  {
    wires.rules.released = keyCurves(context.network, context.piece, context.cut, context.curves);
  }
  wires.problem =
    makeWireProblem(context.network, context.piece, context.cut, context.curves, wires.rules);
  std::optional<PieceSolution> piece =
    warpFromConvexStart(context, wires, context.options.isometric);
  if (piece)
  {
    piece->fromConvexStart = false;
    layOnCloth(context, *piece);
    noteStatus(piece->placement, piece->status);
  }
  return piece;
}

/// Angles without a solution were only a start; where there is a remedy it is named.
void forgetAngles(const PieceContext& context, PieceSolution& piece)
{
  const bool good = piece.status.remedies.empty() && piece.placement.ok() && piece.isometric &&
    piece.isometric->status.ok() && countFlipped(context.piece.mesh, piece.positions) == 0;
  if (good && piece.status.code == StatusCode::NotConverged)
  {
    piece.status = {};
  }
}
}

void finishScheme(const PieceContext& context, PieceSolution& piece)
{
  const bool warps = context.options.scheme == Scheme::Isometric && !piece.status.refused() &&
    !piece.placement.refused();
  if (warps)
  {
    warpPiece(context, piece);
  }
  layOnCloth(context, piece);
  if (warps)
  {
    forgetAngles(context, piece);
  }
  noteStatus(piece.placement, piece.status);
}

PieceSolution flattenByScheme(const PieceContext& context, const CurveRules& rules)
{
  if (context.network.status.refused())
  {
    PieceSolution piece;
    piece.status = context.network.status;
    return piece;
  }
  if (context.options.scheme == Scheme::LeastSquaresConformal)
  {
    return flattenConformally(context);
  }
  Stopwatch watch;
  if (std::optional<PieceSolution> continued = warpFromGivenStart(context, rules))
  {
    continued->secondsInterior = watch.seconds();
    return std::move(*continued);
  }
  if (rules.freeBoundary)
  {
    if (std::optional<PieceSolution> freely = flattenFreely(context, rules))
    {
      freely->secondsInterior = watch.seconds();
      return std::move(*freely);
    }
  }
  watch.restart();
  PieceSolution piece = solveWithKeys(context, rules);
  double seconds = watch.restart();
  if (std::optional<PieceSolution> deep = flattenDeepPiece(context, piece))
  {
    deep->secondsWires = seconds;
    deep->secondsInterior = watch.seconds();
    return std::move(*deep);
  }
  placeWires(context, piece);
  const bool solved = piece.status.ok();
  finishScheme(context, piece);
  double interior = watch.restart();
  std::optional<PieceSolution> released;
  if (solved)
  {
    released = releaseFoldingKeys(context, piece);
    seconds += watch.restart();
  }
  if (released)
  {
    piece = std::move(*released);
    finishScheme(context, piece);
    interior += watch.seconds();
  }
  piece.secondsWires = seconds;
  piece.secondsInterior = interior;
  return piece;
}
}
