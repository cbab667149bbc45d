// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/NotchMarks.h"

#include "Base/Types.h"
#include "Fairing/FairBorders.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
namespace
{
/// Of a sew line from the cut line, for a notch to lie between them; millimetres.
constexpr double leastRoom = 0.2;
}

Point2 NotchMarks::onCutLine(const Point2& from, const Point2& direction) const
{
  for (const double at : crossings(from, direction, this->CutLine))
  {
    if (at > -1e-6)
    {
      return from + std::max(at, 0.0) * direction;
    }
  }
  return from;
}

void NotchMarks::add(
  const Point2& foot, const Point2& outward, double arcLength, const std::string& name)
{
  Notch notch;
  notch.foot = foot;
  notch.from = this->onCutLine(foot, outward);
  const double room = (notch.from - foot).norm();
  // A cut into the allowance stays clear of the seam; without allowance it is a short mark.
  const double most = this->All.options.notchLength;
  const double length = room > leastRoom ? std::min(most, 0.6 * room) : std::min(most, 3.0);
  notch.to = notch.from - length * outward;
  notch.arcLength = arcLength;
  notch.name = name;
  this->Drawing.notches.push_back(std::move(notch));
}

void NotchMarks::addAcross(
  const Point2& foot, const Point2& outward, double arcLength, const std::string& name)
{
  Notch notch;
  notch.onCutLine = false;
  notch.foot = foot;
  const double half = std::min(this->All.options.notchLength, 5.0) / 2.0;
  notch.from = foot + half * outward;
  notch.to = foot - half * outward;
  notch.arcLength = arcLength;
  notch.name = name;
  this->Drawing.notches.push_back(std::move(notch));
}

void NotchMarks::add(const BorderMark& mark)
{
  Point2 outOfFirst;
  Point2 outOfSecond;
  const Point2 foot = pointOnDrawnEdge(this->All, mark.before, mark.point, 1.0, outOfFirst);
  pointOnDrawnEdge(this->All, mark.point, mark.after, 0.0, outOfSecond);
  const double arcLength = this->All.scale() * mark.arcLength;
  if (!mark.corner || cross(outOfFirst, outOfSecond) <= 0.0)
  {
    this->add(foot, (outOfFirst + outOfSecond).normalized(), arcLength, mark.name);
    return;
  }
  for (const Point2& onwards :
    { Point2(-outOfFirst.y(), outOfFirst.x()), Point2(outOfSecond.y(), -outOfSecond.x()) })
  {
    // Without an allowance the corner is mark enough.
    if ((this->onCutLine(foot, onwards) - foot).norm() > leastRoom)
    {
      this->add(foot, onwards, arcLength, mark.name);
    }
  }
}
}
}
