// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Editing/EditedCurve.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace flattening
{
/// What edits make of a curve's nodes and of the kinds of its segments. The segments are those that
/// there were, cut and joined: hints to drawCurve(), and empty where there was none.

template <typename Value>
typename std::vector<Value>::iterator at(std::vector<Value>& values, std::size_t k)
{
  return values.begin() + static_cast<std::ptrdiff_t>(k);
}

/// Three nodes make a loop, and two by a plane section round the surface.
bool canBeClosed(const EditedCurve& curve);
/// Closed or opened between the last node and the first. \pre canBeClosed(curve)
EditedCurve withClosed(EditedCurve curve, bool closed);
/// \param node the number that the node gets, at most as many as there are
/// \param kind of the segments to its neighbours
EditedCurve withNode(
  EditedCurve curve, std::size_t node, const SurfacePoint& point, SegmentKind kind);
/// Opened where too few nodes are left for a loop. \pre There are two nodes or more.
EditedCurve withoutNode(EditedCurve curve, std::size_t node);
/// A closed curve as an open one that starts and ends at a node.
EditedCurve openedAt(EditedCurve curve, std::size_t node);
/// An open curve up to an inner node, and from there.
std::pair<EditedCurve, EditedCurve> dividedAt(const EditedCurve& curve, std::size_t node);
/// Two open curves as one, joined where their ends are nearest to each other.
EditedCurve joined(EditedCurve first, EditedCurve second);
}
