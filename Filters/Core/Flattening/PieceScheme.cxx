// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceScheme.h"

#include "Angles/WireProblem.h"
#include "Base/Stopwatch.h"

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
    warpPlacedPiece(context, flat.wires, flat.placed);
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
