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
  bool twice = false; ///< with both banks
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
    const Triangle& corners = piece.mesh.triangle(static_cast<Index>(h / 3));
    const Index from = corners[h % 3];
    const Index to = corners[(h + 1) % 3];
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

Status invalid(const std::string& message, const std::string& give)
{
  return { StatusCode::InvalidOption, message, {}, { { Remedy::Give, give } } };
}

Status checkEase(double fraction, const FeatureCurve& curve)
{
  const std::string what = "the ease of \"" + curve.name + "\"";
  if (!std::isfinite(fraction) || !(std::abs(fraction) < 1.0))
  {
    return invalid(what + " is " + shortNumber(fraction), "a fraction between -1 and 1");
  }
  if (std::abs(fraction) > curve.tolerance)
  {
    return invalid(what + " is " + percent(fraction) + ", and its length may change by " +
        (curve.tolerance > 0.0 ? "no more than " + percent(curve.tolerance) : "nothing"),
      "the curve a length tolerance as large, or less ease");
  }
  return {};
}

/// Decides the stretches of curves one by one.
class EaseDecision
{
public:
  EaseDecision(const std::vector<FeatureCurve>& curves, const CutSurface& cut,
    const std::vector<const Piece*>& pieces, PieceStretches& stretches)
    : Curves(curves)
    , Cut(cut)
    , Pieces(pieces)
    , Stretches(stretches)
  {
  }

  Status decide(std::size_t c, const LengthEase& ease)
  {
    const std::string& name = this->Curves[c].name;
    Status status = checkEase(ease.fraction, this->Curves[c]);
    if (!status.ok())
    {
      return status;
    }
    std::vector<Presence> presence;
    std::string places;
    std::size_t count = 0;
    std::size_t only = 0;
    for (std::size_t p = 0; p < this->Pieces.size(); ++p)
    {
      presence.push_back(presenceOf(static_cast<Index>(c), *this->Pieces[p], this->Cut));
      if (presence[p].there)
      {
        places += (count++ > 0 ? ", " : "") + std::to_string(p + 1);
        only = p;
      }
    }
    const std::string lies = "\"" + name + "\" lies in piece " + places;
    if (ease.piece == none && count != 1)
    {
      return invalid("an ease names no piece, and " + lies, "the one piece that is to be eased");
    }
    const std::size_t chosen = ease.piece == none ? only : static_cast<std::size_t>(ease.piece);
    if (chosen >= this->Pieces.size() || !presence[chosen].there)
    {
      return invalid(
        "an ease is for piece " + std::to_string(chosen + 1) + ", and " + lies, "one of these");
    }
    if (presence[chosen].twice)
    {
      return invalid("both sides of \"" + name + "\" lie in piece " + std::to_string(chosen + 1) +
          ", which therefore cannot ease one onto the other",
        "the ease of another curve");
    }
    this->Stretches.resize(
      this->Pieces.size(), std::vector<std::optional<double>>(this->Curves.size()));
    for (std::size_t p = 0; p < this->Pieces.size(); ++p)
    {
      if (presence[p].there && (p == chosen || !this->Stretches[p][c]))
      {
        this->Stretches[p][c] = p == chosen ? ease.fraction : 0.0;
      }
    }
    return {};
  }

private:
  const std::vector<FeatureCurve>& Curves;
  const CutSurface& Cut;
  const std::vector<const Piece*>& Pieces;
  PieceStretches& Stretches;
};
}

Status decideEases(const std::vector<CurveEase>& eases, const std::vector<FeatureCurve>& curves,
  const CutSurface& cut, const std::vector<const Piece*>& pieces, PieceStretches& stretches)
{
  stretches.clear();
  EaseDecision decision(curves, cut, pieces, stretches);
  std::vector<bool> decided(curves.size(), false);
  for (const CurveEase& ease : eases)
  {
    bool known = false;
    for (std::size_t c = 0; c < curves.size(); ++c)
    {
      if (curves[c].name == ease.curve)
      {
        known = true;
        decided[c] = true;
        Status status = decision.decide(c, { ease.fraction, ease.piece });
        if (!status.ok())
        {
          return status;
        }
      }
    }
    if (!known)
    {
      return { StatusCode::InvalidOption, "no curve is named \"" + ease.curve + "\", to be eased",
        {}, { { Remedy::Give, "the name of a curve that is there" } } };
    }
  }
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    Status status =
      decided[c] || curves[c].ease.fraction == 0.0 ? Status() : decision.decide(c, curves[c].ease);
    if (!status.ok())
    {
      return status;
    }
  }
  return {};
}
}
