// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/KeyReleasing.h"

#include "Angles/KeyRelease.h"
#include "Quality/FlatteningQuality.h"

#include <iterator>

namespace flattening
{
namespace
{
/// Trials that are kept, so that the chosen one need not be solved again.
constexpr std::size_t mostKept = 64;

bool folds(const PieceContext& context, const PlacedPiece& placed)
{
  return context.options.interior.method == InteriorMethod::AsRigidAsPossible &&
    !placed.status.refused() && countFlipped(context.piece.mesh, placed.positions) > 0;
}

PlacedWires solve(const PieceContext& context, const CurveRules& rules)
{
  PlacedWires result;
  result.wires = solveWires(context, rules);
  result.status = result.wires.angles.status;
  return result;
}

CurveRules withReleased(CurveRules rules, const Indices& released)
{
  Indices all;
  std::set_union(rules.released.begin(), rules.released.end(), released.begin(), released.end(),
    std::back_inserter(all));
  rules.released = std::move(all);
  return rules;
}

/// \param flat whether a trial counts only where the piece lies without a fold; then trials are
/// placed. \return nothing where no release helps
std::optional<PlacedWires> release(
  const PieceContext& context, const CurveRules& rules, const Indices& keys, bool flat)
{
  std::map<Indices, PlacedWires> good;
  std::optional<PlacedWires> cancelled;
  const auto objective = [&](const Indices& released) -> std::optional<double> {
    if (cancelled)
    {
      return std::nullopt;
    }
    PlacedWires trial = solve(context, withReleased(rules, released));
    bool helps = trial.status.ok();
    if (helps && flat)
    {
      place(context, trial);
      helps = !trial.placed.status.refused() && !folds(context, trial.placed);
      noteStatus(trial.placed.status, trial.status);
    }
    if (trial.status.code == StatusCode::Cancelled)
    {
      cancelled = std::move(trial);
      return std::nullopt;
    }
    const double value = trial.wires.angles.objective;
    if (helps)
    {
      good[released] = std::move(trial);
      if (good.size() > mostKept)
      {
        good.erase(good.begin());
      }
    }
    return helps ? std::optional<double>(value) : std::nullopt;
  };
  const KeyRelease found = releaseKeys(keys, objective);
  if (cancelled || found.released.empty())
  {
    return cancelled;
  }
  const auto chosen = good.find(found.released);
  PlacedWires result = chosen != good.end() ? std::move(chosen->second)
                                            : solve(context, withReleased(rules, found.released));
  result.status = describeRelease(context.curves, keys, found);
  return result;
}
}

void place(const PieceContext& context, PlacedWires& result)
{
  if (result.placed.positions.empty() && !result.status.refused())
  {
    result.placed = placeWires(context, result.wires);
  }
}

PlacedWires solveWithKeys(const PieceContext& context, const CurveRules& rules)
{
  CurveRules asked = rules;
  const Indices keys = keyCurves(context.network, context.piece, context.cut, context.curves);
  if (context.options.releaseKeys)
  {
    asked.released = keys;
  }
  PlacedWires result = solve(context, asked);
  if (result.wires.locks() && !result.status.ok() && !result.status.refused())
  {
    std::optional<PlacedWires> released = release(context, asked, keys, false);
    if (released)
    {
      result = std::move(*released);
    }
    else if (result.status.code == StatusCode::IncompatibleKeys)
    {
      result.status = describeClash(context.curves, keys);
    }
  }
  return result;
}

std::optional<PlacedWires> placeWithoutFoldingKeys(
  const PieceContext& context, const PlacedPiece& folded, const WireSolution& wires)
{
  if (!wires.locks() || !folds(context, folded))
  {
    return std::nullopt;
  }
  std::optional<PlacedWires> released = release(context, wires.rules,
    keyCurves(context.network, context.piece, context.cut, context.curves), true);
  if (released)
  {
    place(context, *released);
  }
  return released;
}
}
