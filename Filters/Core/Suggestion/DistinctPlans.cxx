// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/DistinctPlans.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// In sqrt(area / pi): how far plans that differ lie apart.
constexpr double plansApart = 0.15;
}

std::vector<CutPlan> distinctPlans(
  const SearchedPiece& piece, const std::vector<CutPlan>& plans, Index most)
{
  std::vector<CutPlan> chosen;
  const double apart = plansApart * piece.size();
  const auto alike = [&](const CutPlan& a, const CutPlan& b) {
    const auto near = [&](const Point3& p, const Point3& q) { return (p - q).norm() < apart; };
    const Point3 a1 = piece.baseOf(a);
    const Point3 a2 = piece.endOf(a);
    const Point3 b1 = piece.baseOf(b);
    const Point3 b2 = piece.endOf(b);
    const bool turned = (a.type == CurveType::Seam || a.start) && near(a1, b2) && near(a2, b1);
    const bool sameWay = a.via.has_value() == b.via.has_value() && (!a.via || near(*a.via, *b.via));
    return a.type == b.type && a.start.has_value() == b.start.has_value() && sameWay &&
      ((near(a1, b1) && near(a2, b2)) || turned);
  };
  for (const CutPlan& plan : plans)
  {
    if (static_cast<Index>(chosen.size()) >= most)
    {
      break;
    }
    if (std::none_of(
          chosen.begin(), chosen.end(), [&](const CutPlan& other) { return alike(plan, other); }))
    {
      chosen.push_back(plan);
    }
  }
  return chosen;
}
}
