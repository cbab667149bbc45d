// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/OffsetTrack.h"

#include "Base/Planar.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
OffsetTrack::OffsetTrack(const OffsetWindow& window)
  : Origin(window.apex)
{
  if (window.strip)
  {
    this->Origin += window.reach * window.normal;
    this->Way = Point2(window.normal.y(), -window.normal.x());
    this->Whole = { this->Way.dot(window.left - this->Origin),
      this->Way.dot(window.right - this->Origin) };
    return;
  }
  this->Radius = window.reach;
  const double right = std::atan2(window.rightWay.y(), window.rightWay.x());
  const double span =
    std::atan2(cross(window.rightWay, window.leftWay), window.rightWay.dot(window.leftWay));
  this->Whole = { -right - span, -right };
}

Point2 OffsetTrack::at(double along) const
{
  return this->isArc()
    ? Point2(this->Origin + this->Radius * Point2(std::cos(along), -std::sin(along)))
    : Point2(this->Origin + along * this->Way);
}

Point2 OffsetTrack::tangentsMeet(double from, double to) const
{
  const double half = 0.5 * (to - from);
  return this->Origin + (this->at(from + half) - this->Origin) / std::cos(half);
}

TrackParts OffsetTrack::where(const Point2& gradient, double constant) const
{
  const double atOrigin = gradient.dot(this->Origin) + constant;
  TrackParts parts;
  const auto add = [&](double from, double to) {
    const SegmentPart part{ std::max(from, this->Whole.from), std::min(to, this->Whole.to) };
    if (part.to > part.from)
    {
      parts.push_back(part);
    }
  };
  if (!this->isArc())
  {
    const double rate = gradient.dot(this->Way);
    if (rate == 0.0)
    {
      return atOrigin < 0.0 ? parts : TrackParts{ this->Whole };
    }
    const double zero = -atOrigin / rate;
    rate > 0.0 ? add(zero, this->Whole.to) : add(this->Whole.from, zero);
    return parts;
  }
  const double most = this->Radius * gradient.norm();
  if (atOrigin >= most || atOrigin < -most)
  {
    return atOrigin < 0.0 ? parts : TrackParts{ this->Whole };
  }
  const double half = std::acos(-atOrigin / most);
  const double middle = -std::atan2(gradient.y(), gradient.x());
  const double first = std::ceil((this->Whole.from - middle - half) / (2.0 * pi));
  for (double turn = middle + 2.0 * pi * first; turn - half < this->Whole.to; turn += 2.0 * pi)
  {
    add(turn - half, turn + half);
  }
  return parts;
}

TrackParts OffsetTrack::inDisc(const Point2& center, double radius) const
{
  const Point2 way = center - this->Origin;
  if (this->isArc())
  {
    const double apart = way.norm();
    const double more = (radius - this->Radius) * (radius + this->Radius);
    const Point2 gradient = way / apart;
    return this->where(gradient, 0.5 * (more / apart - apart) - gradient.dot(this->Origin));
  }
  const double beside = std::abs(cross(this->Way, way));
  if (!(beside < radius))
  {
    return {};
  }
  const double half = std::sqrt((radius - beside) * (radius + beside));
  const double middle = this->Way.dot(way);
  return intersection({ { middle - half, middle + half } }, { this->Whole });
}

TrackParts intersection(const TrackParts& a, const TrackParts& b)
{
  TrackParts parts;
  for (const SegmentPart& one : a)
  {
    for (const SegmentPart& other : b)
    {
      const SegmentPart part{ std::max(one.from, other.from), std::min(one.to, other.to) };
      if (part.to > part.from)
      {
        parts.push_back(part);
      }
    }
  }
  return parts;
}

TrackParts difference(const TrackParts& a, const TrackParts& b)
{
  TrackParts left = a;
  for (const SegmentPart& gone : b)
  {
    TrackParts rest;
    for (const SegmentPart& part : left)
    {
      const SegmentPart before{ part.from, std::min(part.to, gone.from) };
      const SegmentPart after{ std::max(part.from, gone.to), part.to };
      for (const SegmentPart& kept : { before, after })
      {
        if (kept.to > kept.from)
        {
          rest.push_back(kept);
        }
      }
    }
    left = std::move(rest);
  }
  return left;
}
}
