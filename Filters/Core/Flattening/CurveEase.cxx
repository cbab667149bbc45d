// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/CurveEase.h"

#include <cmath>
#include <set>
#include <utility>

namespace flattening
{
namespace
{
/// How a curve lies in a piece.
struct Presence
{
  bool there = false;
  bool twice = false; ///< with both sides
};

Presence presenceOf(Index curve, const Piece& piece, const CutSurface& cut)
{
  Presence presence;
  std::set<std::pair<Index, Index>> here;
  std::set<std::pair<Index, Index>> before; // the cut
  for (std::size_t h = 0; h < piece.curveOfHalfedge.size(); ++h)
  {
    if (piece.curveOfHalfedge[h] != curve)
    {
      continue;
    }
    presence.there = true;
    const Index from = piece.mesh.from(static_cast<Index>(h));
    const Index to = piece.mesh.to(static_cast<Index>(h));
    const auto original = [&](Index v) { return cut.originalVertex[piece.vertices[v]]; };
    if (here.insert(std::minmax(from, to)).second)
    {
      const Index a = original(from);
      const Index b = original(to);
      presence.twice = !before.insert({ std::min(a, b), std::max(a, b) }).second || presence.twice;
    }
  }
  return presence;
}

Status checkEase(double fraction, const FeatureCurve& curve)
{
  const std::string what = "the ease of \"" + curve.name + "\"";
  if (!std::isfinite(fraction) || !(std::abs(fraction) < 1.0))
  {
    return invalidOption(what + " is " + shortNumber(fraction), "a fraction between -1 and 1");
  }
  if (std::abs(fraction) > curve.tolerance)
  {
    return invalidOption(what + " is " + percent(fraction) + ", and its length may change by " +
        (curve.tolerance > 0.0 ? "no more than " + percent(curve.tolerance) : "nothing"),
      "the curve a length tolerance as large, or less ease");
  }
  return {};
}

Status decideEase(Index curve, const LengthEase& ease, const std::vector<FeatureCurve>& curves,
  const CutSurface& cut, const std::vector<const Piece*>& pieces, PieceStretches& stretches)
{
  const std::string name = "\"" + curves[curve].name + "\"";
  Status status = checkEase(ease.fraction, curves[curve]);
  if (!status.ok())
  {
    return status;
  }
  std::vector<Presence> presence;
  std::string places;
  Index count = 0;
  std::size_t chosen = static_cast<std::size_t>(ease.piece);
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    presence.push_back(presenceOf(curve, *pieces[p], cut));
    if (presence[p].there)
    {
      places += (count++ > 0 ? ", " : "") + std::to_string(p + 1);
      chosen = ease.piece == none ? p : chosen;
    }
  }
  const std::string lies = name + " lies in piece " + places;
  if (ease.piece == none && count != 1)
  {
    return invalidOption(
      "an ease names no piece, and " + lies, "the one piece that is to be eased");
  }
  if (chosen >= pieces.size() || !presence[chosen].there)
  {
    return invalidOption(
      "an ease is for piece " + std::to_string(chosen + 1) + ", and " + lies, "one of these");
  }
  if (presence[chosen].twice)
  {
    return invalidOption("both sides of " + name + " lie in piece " + std::to_string(chosen + 1) +
        ", which therefore cannot ease one onto the other",
      "the ease of another curve");
  }
  stretches.resize(pieces.size(), CurveStretches(curves.size()));
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    std::optional<double>& stretch = stretches[p][curve];
    if (presence[p].there && (p == chosen || !stretch))
    {
      stretch = p == chosen ? ease.fraction : 0.0;
    }
  }
  return {};
}
}

Status decideEases(const std::vector<CurveEase>& eases, const std::vector<FeatureCurve>& curves,
  const CutSurface& cut, const std::vector<const Piece*>& pieces, PieceStretches& stretches)
{
  stretches.clear();
  const auto count = static_cast<Index>(curves.size());
  std::vector<char> decided(curves.size(), 0);
  const auto decide = [&](Index c, const LengthEase& ease) {
    decided[c] = 1;
    return decideEase(c, ease, curves, cut, pieces, stretches);
  };
  Status status;
  for (const CurveEase& ease : eases)
  {
    bool known = false;
    for (Index c = 0; c < count && status.ok(); ++c)
    {
      if (curves[c].name == ease.curve)
      {
        known = true;
        status = decide(c, { ease.fraction, ease.piece });
      }
    }
    if (!known && status.ok())
    {
      return invalidOption("no curve is named \"" + ease.curve + "\", to be eased",
        "the name of a curve that is there");
    }
  }
  for (Index c = 0; c < count && status.ok(); ++c)
  {
    if (!decided[c] && curves[c].ease.fraction != 0.0)
    {
      status = decide(c, curves[c].ease);
    }
  }
  return status;
}
}
