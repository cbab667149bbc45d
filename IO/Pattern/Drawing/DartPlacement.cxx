// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/DartPlacement.h"

#include "Base/Types.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace pattern
{
DartPlacement::DartPlacement(const DrawingSource& all, const Indices& loop, const Dart& dart)
  : TwoTips(dart.otherTip != none)
{
  const Index from = loop[dart.firstEdge];
  const Index to = loop[(dart.firstEdge + 1) % loop.size()];
  this->Back = all.valueAlong(from, to, all.options.dartTipOfCurve, all.options.dartTip);
  const Point2 tip = all.at(dart.tip);
  const std::array<Point2, 2> others = this->TwoTips
    ? std::array<Point2, 2>{ tip, all.at(dart.otherTip) }
    : std::array<Point2, 2>{ all.at(dart.mouth[0]), all.at(dart.mouth[1]) };
  this->Middle = (others[0] + others[1]) / 2.0;
  this->Mouth = others[1] - others[0];
  const Point2 way = tip - this->Middle;
  this->Depth = (this->TwoTips ? 2.0 : 1.0) * way.norm();
  this->Inwards = this->Depth > 0.0 ? Point2(way.normalized()) : Point2(Point2::Zero());
  const double width = cross(this->Mouth, this->Inwards);
  if (this->TwoTips || std::abs(width) < 1e-9 * this->Depth)
  {
    this->Mouth = Point2(this->Inwards.y(), -this->Inwards.x()); // along which nothing is between
  }
}

Point2 DartPlacement::at(const Point2& point) const
{
  if (this->Back == 0.0 || this->Depth == 0.0)
  {
    return point;
  }
  const double inwards =
    cross(this->Mouth, point - this->Middle) / cross(this->Mouth, this->Inwards);
  const double share = inwards / (this->TwoTips ? this->Depth / 2.0 : this->Depth);
  return point - share * this->Back * this->Inwards;
}

void DartPlacement::place(PatternLine& leg) const
{
  if (this->Back == 0.0)
  {
    return;
  }
  const auto move = [this](Point2& p) { p = this->at(p); };
  std::for_each(leg.points.begin(), leg.points.end(), move);
  leg.restLength = 0.0;
  for (FairSpan& span : leg.curve)
  {
    std::for_each(span.control.begin(), span.control.end(), move);
    leg.restLength += span.length();
  }
  for (std::size_t k = 1; leg.curve.empty() && k < leg.points.size(); ++k)
  {
    leg.restLength += (leg.points[k] - leg.points[k - 1]).norm();
  }
}

Status DartPlacement::check(const std::string& dart, const std::string& piece) const
{
  if (this->Back <= 0.5 * this->Depth)
  {
    return {};
  }
  return { StatusCode::InvalidOption,
    "the tip of the dart " + dart + " of piece " + piece + " cannot be drawn back by " +
      formatNumber(this->Back, 1) + " mm, since the dart is " + formatNumber(this->Depth, 1) +
      " mm deep",
    {}, { Remedy::CheckUnit, { Remedy::Give, "at most half of its depth" } } };
}
}
}
