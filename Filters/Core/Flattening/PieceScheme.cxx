// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceScheme.h"

#include "Angles/WireProblem.h"
#include "Base/Stopwatch.h"
#include "Flattening/ConvexWarping.h"
#include "Quality/FlatteningQuality.h"

namespace flattening
{
namespace
{
FlatWires flattenConformally(const PieceContext& context)
{
  Stopwatch watch;
  FlatWires flat;
  // The map holds no wire, but what it does to them is measured.
  flat.wires.problem = makeAngleProblem(context.network, freeNodes(context.network));
  flat.placed = mapPiece(context);
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
  // Keys that keep it from a minimum had better be released.
  const bool helps = second && (second->status.ok() || !flat.wires.locks());
  if (helps && isBetter(context, *second, flat.placed))
  {
    second->seconds = flat.placed.seconds;
    flat.placed = std::move(*second);
  }
}

/// Angles without a solution were only a start; where there is a way to one it is told.
void forgetAngles(const PieceContext& context, FlatWires& flat)
{
  const bool good = flat.status.waysOut.empty() && flat.placed.status.ok() &&
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
    warpFromBetterStart(context, flat);
    forgetAngles(context, flat);
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
  if (context.options.scheme == Scheme::Conformal)
  {
    return flattenConformally(context);
  }
  Stopwatch watch;
  PlacedWires placed = placeWithKeys(context, rules);
  double seconds = watch.restart() - placed.placed.seconds;
  double interior = placed.placed.seconds;
  const bool solved = placed.status.ok();
  FlatWires flat = finishScheme(context, std::move(placed));
  interior += watch.restart();
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
