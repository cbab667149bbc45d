// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CurveNodes.h"

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
  curve.segments.clear();
  return curve;
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
  return curve;
}

EditedCurve withNode(
  EditedCurve curve, std::size_t node, const SurfacePoint& point, SegmentKind kind)
{
  const std::size_t count = curve.nodes.size();
  // Before the first node of a closed curve is behind its last.
  const std::size_t place = curve.closed && node == 0 ? count : node;
  curve.nodes.insert(at(curve.nodes, place), point);
  if (curve.closed || (node > 0 && node < count))
  {
    const std::size_t divided = place - 1;
    curve.kinds[divided] = kind;
    curve.kinds.insert(at(curve.kinds, divided), kind);
  }
  else
  {
    curve.kinds.insert(at(curve.kinds, place == 0 ? 0 : place - 1), kind);
  }
  return curve;
}

EditedCurve withoutNode(EditedCurve curve, std::size_t node)
{
  curve.nodes.erase(at(curve.nodes, node));
  if (!curve.kinds.empty())
  {
    curve.kinds.erase(at(curve.kinds, std::min(node, curve.kinds.size() - 1)));
  }
  if (curve.closed && !canBeClosed(curve))
  {
    curve.closed = false;
    curve.kinds.resize(segmentCount(curve.nodes.size(), false));
  }
  return curve;
}

EditedCurve openedAt(EditedCurve curve, std::size_t node)
{
  std::rotate(curve.nodes.begin(), at(curve.nodes, node), curve.nodes.end());
  std::rotate(curve.kinds.begin(), at(curve.kinds, node), curve.kinds.end());
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
  second.nodes.erase(second.nodes.begin(), at(second.nodes, node));
  second.kinds.erase(second.kinds.begin(), at(second.kinds, node));
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
  first = nearest < 2 ? first : reversed(std::move(first));
  second = nearest % 2 == 0 ? second : reversed(std::move(second));
  if (first.nodes.back().position == second.nodes.front().position)
  {
    second.nodes.erase(second.nodes.begin());
  }
  else
  {
    first.kinds.push_back(SegmentKind::Geodesic);
  }
  first.nodes.insert(first.nodes.end(), second.nodes.begin(), second.nodes.end());
  first.kinds.insert(first.kinds.end(), second.kinds.begin(), second.kinds.end());
  return first;
}
}
