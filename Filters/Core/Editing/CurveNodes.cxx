// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CurveNodes.h"

#include "Paths/PathPoints.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace flattening
{
namespace
{
/// The curve run through the other way round.
EditedCurve reversed(EditedCurve curve)
{
  std::reverse(curve.nodes.begin(), curve.nodes.end());
  std::reverse(curve.kinds.begin(), curve.kinds.end());
  std::reverse(curve.segments.begin(), curve.segments.end());
  for (SurfacePath& segment : curve.segments)
  {
    segment = reversed(std::move(segment));
  }
  return curve;
}

/// One segment that runs as both; none where one of them is none.
SurfacePath together(SurfacePath first, const SurfacePath& second)
{
  if (first.points.empty() || second.points.empty())
  {
    return {};
  }
  append(first, second);
  return first;
}

/// Both parts of a segment, up to the point of it that is nearest to a place, and from there.
std::pair<SurfacePath, SurfacePath> dividedNear(const SurfacePath& segment, const Point3& place)
{
  if (segment.points.empty())
  {
    return {};
  }
  const auto nearest = std::min_element(segment.points.begin(), segment.points.end(),
    [&place](const SurfacePoint& a, const SurfacePoint& b) {
      return (a.position - place).squaredNorm() < (b.position - place).squaredNorm();
    });
  const auto middle = static_cast<std::size_t>(nearest - segment.points.begin());
  return { partOf(segment, 0, middle), partOf(segment, middle, segment.points.size() - 1) };
}
}

bool canBeClosed(const EditedCurve& curve)
{
  return curve.nodes.size() > 2 ||
    (curve.nodes.size() == 2 && !curve.kinds.empty() &&
      std::all_of(curve.kinds.begin(), curve.kinds.end(),
        [](SegmentKind kind) { return kind == SegmentKind::Section; }));
}

EditedCurve withClosed(EditedCurve curve, bool closed)
{
  if (closed && curve.nodes.front().position == curve.nodes.back().position)
  {
    curve.nodes.pop_back();
  }
  curve.closed = closed;
  curve.kinds.resize(segmentCount(curve.nodes.size(), closed), curve.kinds.back());
  curve.segments.resize(curve.kinds.size());
  return curve;
}

EditedCurve withNode(
  EditedCurve curve, std::size_t node, const SurfacePoint& point, SegmentKind kind)
{
  const std::size_t count = curve.nodes.size();
  curve.segments.resize(curve.kinds.size());
  // Before the first node of a closed curve is behind its last.
  const std::size_t place = curve.closed && node == 0 ? count : node;
  curve.nodes.insert(at(curve.nodes, place), point);
  if (curve.closed || (node > 0 && node < count))
  {
    const std::size_t divided = place - 1;
    curve.kinds[divided] = kind;
    curve.kinds.insert(at(curve.kinds, divided), kind);
    auto [before, after] = dividedNear(curve.segments[divided], point.position);
    curve.segments[divided] = std::move(after);
    curve.segments.insert(at(curve.segments, divided), std::move(before));
  }
  else
  {
    const std::size_t end = place == 0 ? 0 : place - 1;
    curve.kinds.insert(at(curve.kinds, end), kind);
    curve.segments.insert(at(curve.segments, end), SurfacePath());
  }
  return curve;
}

EditedCurve withoutNode(EditedCurve curve, std::size_t node)
{
  const bool inner = curve.closed || (node > 0 && node + 1 < curve.nodes.size());
  curve.nodes.erase(at(curve.nodes, node));
  curve.segments.resize(curve.kinds.size());
  if (!curve.kinds.empty())
  {
    const std::size_t gone = std::min(node, curve.kinds.size() - 1);
    if (inner)
    {
      SurfacePath& before = curve.segments[gone == 0 ? curve.segments.size() - 1 : gone - 1];
      before = together(std::move(before), curve.segments[gone]);
    }
    curve.kinds.erase(at(curve.kinds, gone));
    curve.segments.erase(at(curve.segments, gone));
  }
  if (curve.closed && !canBeClosed(curve))
  {
    curve.closed = false;
    curve.kinds.resize(segmentCount(curve.nodes.size(), false));
    curve.segments.resize(curve.kinds.size());
  }
  return curve;
}

EditedCurve openedAt(EditedCurve curve, std::size_t node)
{
  std::rotate(curve.nodes.begin(), at(curve.nodes, node), curve.nodes.end());
  std::rotate(curve.kinds.begin(), at(curve.kinds, node), curve.kinds.end());
  curve.segments.resize(curve.kinds.size());
  std::rotate(curve.segments.begin(), at(curve.segments, node), curve.segments.end());
  curve.nodes.push_back(curve.nodes.front());
  curve.closed = false;
  return curve;
}

std::pair<EditedCurve, EditedCurve> dividedAt(const EditedCurve& curve, std::size_t node)
{
  EditedCurve first = curve;
  EditedCurve second = curve;
  first.nodes.resize(node + 1);
  first.kinds.resize(node);
  first.segments.resize(node);
  second.nodes.erase(second.nodes.begin(), at(second.nodes, node));
  second.kinds.erase(second.kinds.begin(), at(second.kinds, node));
  second.segments.resize(curve.kinds.size());
  second.segments.erase(second.segments.begin(), at(second.segments, node));
  return { std::move(first), std::move(second) };
}

EditedCurve joined(EditedCurve first, EditedCurve second)
{
  const auto gap = [](const SurfacePoint& a, const SurfacePoint& b) {
    return (a.position - b.position).norm();
  };
  const std::array<double, 4> gaps{ gap(first.nodes.back(), second.nodes.front()),
    gap(first.nodes.back(), second.nodes.back()), gap(first.nodes.front(), second.nodes.front()),
    gap(first.nodes.front(), second.nodes.back()) };
  const auto nearest = std::min_element(gaps.begin(), gaps.end()) - gaps.begin();
  first.segments.resize(first.kinds.size());
  second.segments.resize(second.kinds.size());
  first = nearest < 2 ? first : reversed(std::move(first));
  second = nearest % 2 == 0 ? second : reversed(std::move(second));
  if (first.nodes.back().position == second.nodes.front().position)
  {
    second.nodes.erase(second.nodes.begin());
  }
  else
  {
    first.kinds.push_back(SegmentKind::Geodesic);
    first.segments.emplace_back();
  }
  first.nodes.insert(first.nodes.end(), second.nodes.begin(), second.nodes.end());
  first.kinds.insert(first.kinds.end(), second.kinds.begin(), second.kinds.end());
  first.segments.insert(first.segments.end(), second.segments.begin(), second.segments.end());
  return first;
}
}
