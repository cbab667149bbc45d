// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <utility>

namespace flattening
{
/// What ids are ids of.
enum class ElementKind
{
  None,
  Points, ///< of the surface
  Cells,  ///< triangles
  Curves,
  CurvePoints, ///< in the caller's data of the curve
  Edges,       ///< pairs of points of the surface
  WirePatches, ///< of a piece
  WireNodes,   ///< of a piece
};

/// Ids that know what they are ids of; wide enough for those of any caller.
struct ElementIds
{
  ElementKind kind = ElementKind::None;
  std::vector<std::int64_t> values;

  ElementIds() = default;
  ElementIds(ElementKind what, const Indices& ids)
    : ElementIds(what, std::vector<std::int64_t>(ids.begin(), ids.end()))
  {
  }
  ElementIds(ElementKind what, std::vector<std::int64_t> ids)
    : kind(ids.empty() ? ElementKind::None : what)
    , values(std::move(ids))
  {
  }

  bool empty() const { return this->values.empty(); }
  bool operator==(const ElementIds& other) const
  {
    return this->kind == other.kind && this->values == other.values;
  }
};
}
