// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/MovedPlans.h"

namespace flattening
{
std::vector<CutPlan> movedPlans(const SearchedPiece& piece, const CutPlan& plan, double step)
{
  std::vector<CutPlan> plans;
  const BoundaryRuler& ruler = piece.ruler();
  const auto addMoved = [&](double base, double end) {
    CutPlan moved = plan;
    moved.base = ruler.moved(plan.base, base);
    moved.end = plan.type == CurveType::Seam ? ruler.moved(plan.end, end) : plan.end;
    if (piece.worth(moved.base) > 0.0)
    {
      plans.push_back(moved);
    }
  };
  const bool along = plan.role == MirrorRole::Along;
  for (double by : { step, -step })
  {
    if (!along && !plan.start)
    {
      addMoved(by, 0.0);
    }
    if (plan.type == CurveType::Seam && plan.role != MirrorRole::Across && !along)
    {
      addMoved(0.0, by);
      addMoved(by, by);
      addMoved(by, -by);
    }
  }
  if (plan.via)
  {
    const Point3 ahead = (piece.endOf(plan) - piece.baseOf(plan)).normalized();
    const Point3 aside = piece.normalNear(*plan.via).cross(ahead);
    for (double by : { step, -step })
    {
      CutPlan moved = plan;
      const Point3 place = *plan.via + by * aside;
      const bool inPlane = along || plan.role == MirrorRole::Across;
      moved.via = piece.onto(inPlane ? piece.mirror()->projected(place) : place);
      plans.push_back(moved);
    }
  }
  if (plan.type == CurveType::Dart)
  {
    const Point3 ahead = (plan.tip - piece.baseOf(plan)).normalized();
    const Point3 aside = piece.normalNear(plan.tip).cross(ahead);
    for (double by : { step, -step })
    {
      for (const Point3& direction : { ahead, aside })
      {
        const auto placed = [&](const Point3& point) {
          return piece.onto(along ? piece.mirror()->projected(point) : point);
        };
        CutPlan moved = plan;
        moved.tip = placed(plan.tip + by * direction);
        if (!plan.start || piece.takesInnerTip(moved.tip))
        {
          plans.push_back(moved);
        }
        if (plan.start)
        {
          moved = plan;
          moved.start = placed(*plan.start + by * direction);
          if (piece.takesInnerTip(*moved.start))
          {
            plans.push_back(moved);
          }
        }
      }
    }
  }
  return plans;
}

std::vector<CutPlan> slidPlans(
  const SearchedPiece& piece, const CutPlan& plan, double step, bool turned)
{
  std::vector<CutPlan> plans;
  if (plan.type != CurveType::Dart || plan.start || plan.role == MirrorRole::Along)
  {
    return plans;
  }
  for (double by : { step, -step })
  {
    CutPlan moved = plan;
    moved.base = piece.ruler().moved(plan.base, by);
    moved.tip = piece.onto(plan.tip + piece.baseOf(moved) - piece.baseOf(plan));
    if (piece.worth(moved.base) > 0.0)
    {
      plans.push_back(moved);
      if (turned)
      {
        moved.tip = piece.onto(plan.tip - (piece.baseOf(moved) - piece.baseOf(plan)));
        plans.push_back(moved);
      }
    }
  }
  return plans;
}
}
