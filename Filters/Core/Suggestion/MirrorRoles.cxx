// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/MirrorRoles.h"

namespace flattening
{
namespace
{
/// How far cuts stay from the mirror plane or lie in it, in sqrt(area / pi).
constexpr double clearOfPlane = 0.04;
}

MirrorRoles::MirrorRoles(const SearchedPiece& piece, bool pairs)
  : Piece(piece)
  , Pairs(pairs)
  , Margin(clearOfPlane * piece.size())
{
}

int MirrorRoles::side(const Point3& point) const
{
  const double distance = this->Piece.mirror()->side(point);
  return distance > this->Margin ? 1 : distance < -this->Margin ? -1 : 0;
}

bool MirrorRoles::takeOver(Index base, Index end, CutPlan& plan) const
{
  const int top = this->side(*plan.via);
  if (top == 0)
  {
    plan.via = this->Piece.onto(this->Piece.mirror()->projected(*plan.via));
    if (end == this->mirroredBase(base))
    {
      plan.role = MirrorRole::Across;
      return true;
    }
  }
  if (!this->take(this->Piece.mesh().point(base), this->Piece.mesh().point(end), plan) ||
    this->side(this->Piece.mesh().point(base)) != top)
  {
    return false;
  }
  if (plan.role == MirrorRole::Along)
  {
    this->bringIntoPlane(plan);
  }
  return true;
}

Index MirrorRoles::mirroredBase(Index base) const
{
  return this->Piece.ruler().vertex(this->Piece.mirrored(this->Piece.ruler().placeOf(base)));
}

bool MirrorRoles::take(const Point3& from, const Point3& to, CutPlan& plan) const
{
  if (!this->Piece.mirror())
  {
    return true;
  }
  const int a = this->side(from);
  const int b = this->side(to);
  if (a == 0 && b == 0)
  {
    plan.role = MirrorRole::Along;
    return true;
  }
  plan.role = MirrorRole::Pair;
  return a * b > 0 && this->Pairs;
}

void MirrorRoles::bringIntoPlane(CutPlan& plan) const
{
  const SurfaceMirror& plane = *this->Piece.mirror();
  plan.base = this->inPlane(plan.base);
  if (plan.type == CurveType::Seam)
  {
    plan.end = this->inPlane(plan.end);
  }
  else
  {
    plan.tip = this->Piece.onto(plane.projected(plan.tip));
  }
}

/// Where the boundary crosses the plane near a place.
BoundaryPlace MirrorRoles::inPlane(BoundaryPlace place) const
{
  const BoundaryRuler& ruler = this->Piece.ruler();
  const SurfaceMirror& plane = *this->Piece.mirror();
  double low = -2.0 * this->Margin;
  double high = 2.0 * this->Margin;
  const auto at = [&](double by) { return plane.side(ruler.point(ruler.moved(place, by))); };
  if (at(low) * at(high) > 0.0)
  {
    return place;
  }
  const bool rising = at(high) > 0.0;
  for (int halving = 0; halving < 60; ++halving)
  {
    const double middle = 0.5 * (low + high);
    ((at(middle) > 0.0) == rising ? high : low) = middle;
  }
  return ruler.moved(place, 0.5 * (low + high));
}
}
