// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceScheme.h"

#include "Angles/AngleProblem.h"
#include "Base/Stopwatch.h"
#include "Embedding/ConvexEmbedding.h"
#include "Flattening/ClothWarping.h"
#include "Flattening/ContinuedWarping.h"
#include "Flattening/ConvexWarping.h"
#include "Quality/FlatteningQuality.h"

namespace flattening
{
namespace
{
/// Larger tubes are only mapped: warping one takes minutes, and nothing can be cut by the result.
constexpr Index mostTubeTriangles = 20000;

FlatWires flattenConformally(const PieceContext& context)
{
  Stopwatch watch;
  FlatWires flat;
  // The map holds no wire, but what it does to them is measured.
  flat.wires.problem = makeAngleProblem(context.network, freeNodes(context.network));
  flat.placed = mapPiece(context);
  layOnCloth(context, flat.wires, flat.placed);
  flat.status = flat.placed.status;
  flat.secondsInterior = watch.seconds();
  return flat;
}

/// The isometric scheme from where the wires' angles have put the piece; where the result is
/// doubtful, from a convex embedding as well, and the better one counts.
void warpFromBetterStart(const PieceContext& context, FlatWires& flat)
{
  warpPlacedPiece(context, flat.wires, flat.placed);
  if (flat.placed.status.refused() || !isDoubtful(context, flat.placed))
  {
    return;
  }
  std::optional<PlacedPiece> second = warpFromConvexStart(context, flat.wires);
  if (second)
  {
    flat.placed.factorizations += second->factorizations;
    second->factorizations = flat.placed.factorizations;
  }
  // Keys that keep it from a minimum had better be released.
  const bool helps = second && (second->status.ok() || !flat.wires.locks());
  if (helps && isBetter(context, *second, flat.placed))
  {
    second->seconds = flat.placed.seconds;
    flat.placed = std::move(*second);
  }
}

/// A tube without its lengths. Without a value where it cannot be mapped or the run was cancelled.
std::optional<FlatWires> mapTube(const PieceContext& context, const PlacedWires& solved)
{
  FlatWires flat;
  flat.wires = solved.wires;
  flat.placed.positions = embedConvexly(context.piece.mesh, context.execution);
  if (flat.placed.positions.empty())
  {
    return std::nullopt;
  }
  flat.status = { StatusCode::NotConverged,
    "the piece is a tube, which no plane can hold; with " +
      std::to_string(context.piece.mesh.triangleCount()) +
      " triangles it is only mapped, without its lengths",
    {}, {} };
  layOnCloth(context, flat.wires, flat.placed);
  return flat;
}

/// A piece for which the plane has no room, from a convex embedding at once: placed by its wires'
/// angles it would fold, and untangling it would take long and help little. Without a value where
/// that does not keep what was asked for.
std::optional<FlatWires> flattenDeepPiece(const PieceContext& context, const PlacedWires& solved)
{
  if (!context.deep() || context.options.scheme != Scheme::Isometric || solved.status.refused())
  {
    return std::nullopt;
  }
  context.execution.report(0.1, "Flattening a piece that no plane can hold");
  if (context.area->tube() && context.piece.mesh.triangleCount() > mostTubeTriangles)
  {
    return mapTube(context, solved);
  }
  std::optional<PlacedPiece> placed = warpFromConvexStart(context, solved.wires);
  const bool good = placed && (placed->status.ok() || !solved.wires.locks()) &&
    countFlipped(context.piece.mesh, placed->positions) == 0;
  if (!good)
  {
    return std::nullopt;
  }
  FlatWires flat;
  flat.wires = solved.wires;
  flat.placed = std::move(*placed);
  layOnCloth(context, flat.wires, flat.placed);
  if (solved.status.code != StatusCode::NotConverged)
  {
    flat.status = solved.status;
  }
  noteStatus(flat.placed.status, flat.status);
  return flat;
}

/// Angles without a solution were only a start; where there is a way to one it is told.
void forgetAngles(const PieceContext& context, FlatWires& flat)
{
  const bool good = flat.status.remedies.empty() && flat.placed.status.ok() &&
    flat.placed.isometric && flat.placed.isometric->status.ok() &&
    countFlipped(context.piece.mesh, flat.placed.positions) == 0;
  if (good && flat.status.code == StatusCode::NotConverged)
  {
    flat.status = {};
  }
}
}

FlatWires finishScheme(const PieceContext& context, PlacedWires placed)
{
  FlatWires flat;
  flat.wires = std::move(placed.wires);
  flat.placed = std::move(placed.placed);
  flat.status = std::move(placed.status);
  const bool refused = flat.status.refused() || flat.placed.status.refused();
  if (context.options.scheme == Scheme::Isometric && !refused)
  {
    FlatteningOptions start = context.options;
    start.isometric.rough =
      context.options.isometric.rough || (start.cloth && !start.cloth->material.isotropic);
    const PieceContext startContext{ context.piece, context.network, context.cut, context.curves,
      start, context.execution, context.interiors, context.area };
    warpFromBetterStart(startContext, flat);
    layOnCloth(context, flat.wires, flat.placed);
    forgetAngles(context, flat);
  }
  else
  {
    layOnCloth(context, flat.wires, flat.placed);
  }
  noteStatus(flat.placed.status, flat.status);
  return flat;
}

FlatWires flattenWires(const PieceContext& context, const CurveRules& rules)
{
  if (context.network.status.refused())
  {
    FlatWires flat;
    flat.status = context.network.status;
    return flat;
  }
  if (context.options.scheme == Scheme::LeastSquaresConformal)
  {
    return flattenConformally(context);
  }
  Stopwatch watch;
  if (std::optional<PlacedWires> continued = warpFromGivenStart(context, rules))
  {
    return { std::move(continued->wires), std::move(continued->placed), {}, 0.0, watch.seconds() };
  }
  watch.restart();
  PlacedWires placed = solveWithKeys(context, rules);
  double seconds = watch.restart();
  if (std::optional<FlatWires> deep = flattenDeepPiece(context, placed))
  {
    deep->secondsWires = seconds;
    deep->secondsInterior = watch.seconds();
    return std::move(*deep);
  }
  place(context, placed);
  const bool solved = placed.status.ok();
  FlatWires flat = finishScheme(context, std::move(placed));
  double interior = watch.restart();
  if (solved)
  {
    std::optional<PlacedWires> released = placeWithoutFoldingKeys(context, flat.placed, flat.wires);
    seconds += watch.restart();
    if (released)
    {
      flat = finishScheme(context, std::move(*released));
      interior += watch.seconds();
    }
  }
  flat.secondsWires = seconds;
  flat.secondsInterior = interior;
  return flat;
}
}
