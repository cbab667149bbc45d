// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/PlannedCut.h"

namespace flattening
{
namespace
{
/// Ends this near to their image, in sqrt(area / pi), lie on the mirror.
constexpr double nearlyImage = 1e-3;

/// Of a cut that is alone on a piece with a mirror.
MirrorRole roleOf(const SearchedPiece& piece, const SuggestedCurve& cut)
{
  const Points3& line = cut.curve.points;
  const auto near = [&](const Point3& a, const Point3& b) {
    return (a - b).norm() < nearlyImage * piece.size();
  };
  const auto onAxis = [&](const Point3& point) {
    return near(piece.mirror()->projected(point), point);
  };
  if (onAxis(line.front()) && onAxis(line.back()))
  {
    return MirrorRole::Along;
  }
  const bool across =
    cut.curve.type == CurveType::Seam && near(piece.mirror()->mirrored(line.front()), line.back());
  return across ? MirrorRole::Across : MirrorRole::Alone;
}
}

std::optional<CutPlan> plannedCut(
  const SearchedPiece& piece, const SuggestedCurve& cut, bool paired, double near)
{
  const Points3& line = cut.curve.points;
  const BoundaryRuler& ruler = piece.ruler();
  const auto onBoundary = [&](const BoundaryPlace& place, const Point3& end) {
    return (ruler.point(place) - end).norm() < near;
  };
  CutPlan plan;
  plan.type = cut.curve.type;
  plan.via = cut.via;
  plan.base = ruler.nearest(line.front(), line[1]);
  plan.tip = line.back();
  if (!onBoundary(plan.base, line.front()))
  {
    plan.start = line.front();
  }
  if (plan.type == CurveType::Seam)
  {
    plan.end = ruler.nearest(line.back(), line[line.size() - 2]);
    if (plan.start || !onBoundary(plan.end, line.back()))
    {
      return {};
    }
  }
  if (paired)
  {
    plan.role = MirrorRole::Pair;
    return piece.mirror() ? std::optional<CutPlan>(plan) : std::nullopt;
  }
  plan.role = piece.mirror() ? roleOf(piece, cut) : MirrorRole::Alone;
  return plan;
}
}
