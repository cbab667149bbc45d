// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/EditedCurve.h"

#include "Base/Types.h"
#include "Paths/PathPoints.h"

#include <algorithm>

namespace flattening
{
namespace
{
bool identical(const SurfacePoint& a, const SurfacePoint& b)
{
  return a.type == b.type && a.id == b.id &&
    sameBits({ Point3(a.weights.data()), a.position }, { Point3(b.weights.data()), b.position });
}

bool identical(const std::vector<SurfacePoint>& a, const std::vector<SurfacePoint>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const SurfacePoint& p, const SurfacePoint& q) { return identical(p, q); });
}

bool identical(const std::vector<SurfacePath>& a, const std::vector<SurfacePath>& b)
{
  return std::equal(
    a.begin(), a.end(), b.begin(), b.end(), [](const SurfacePath& p, const SurfacePath& q) {
      return p.triangles == q.triangles && identical(p.points, q.points);
    });
}

bool identical(const CurveTraits& a, const CurveTraits& b)
{
  return a.name == b.name && a.type == b.type && a.keyShape == b.keyShape &&
    a.tolerance == b.tolerance && a.ease == b.ease && a.mirrored == b.mirrored;
}
}

bool nameTaken(const CurveSet& set, const std::string& name, std::size_t except)
{
  for (std::size_t c = 0; c < set.curves.size(); ++c)
  {
    if (c != except && set.curves[c]->traits.name == name)
    {
      return true;
    }
  }
  return false;
}

std::string freeName(const CurveSet& set, const std::string& wish)
{
  const std::size_t others = set.curves.size();
  if (!wish.empty() && !nameTaken(set, wish, others))
  {
    return wish;
  }
  const std::string stem = wish.empty() ? "curve" : wish;
  std::size_t number = wish.empty() ? 1 : 2;
  while (nameTaken(set, stem + " " + std::to_string(number), others))
  {
    ++number;
  }
  return stem + " " + std::to_string(number);
}

std::size_t segmentCount(std::size_t nodes, bool closed)
{
  return closed ? nodes : std::max<std::size_t>(nodes, 1) - 1;
}

double lengthOf(const EditedCurve& curve)
{
  double length = 0.0;
  for (const SurfacePath& segment : curve.segments)
  {
    length += lengthOf(segment);
  }
  return length;
}

Points3 pointsAlong(const std::vector<SurfacePath>& segments)
{
  Points3 points;
  for (const SurfacePath& segment : segments)
  {
    for (const SurfacePoint& point : segment.points)
    {
      if (points.empty() || points.back() != point.position)
      {
        points.push_back(point.position);
      }
    }
  }
  return points;
}

SurfacePath wholePath(const EditedCurve& curve)
{
  SurfacePath whole;
  for (const SurfacePath& segment : curve.segments)
  {
    if (whole.points.empty())
    {
      whole.points = { segment.points.front() };
    }
    append(whole, segment);
  }
  whole.arrived = !whole.triangles.empty();
  return whole;
}

bool identical(const EditedCurve& a, const EditedCurve& b)
{
  return identical(a.traits, b.traits) && a.closed == b.closed && identical(a.nodes, b.nodes) &&
    a.kinds == b.kinds && identical(a.segments, b.segments) && identical(a.image, b.image);
}

bool identical(const CurveSet& a, const CurveSet& b)
{
  const bool sameMirror = a.mirror.has_value() == b.mirror.has_value() &&
    (!a.mirror ||
      sameBits({ a.mirror->origin, a.mirror->normal }, { b.mirror->origin, b.mirror->normal }));
  return sameMirror &&
    std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(),
      [](const auto& p, const auto& q) { return identical(*p, *q); });
}
}
