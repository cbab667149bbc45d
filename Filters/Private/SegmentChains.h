// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkType.h"

#include <array>
#include <vector>

namespace flattening
{
namespace bridge
{
/// Segments joined end to end.
struct SegmentChain
{
  std::vector<vtkIdType> points; ///< the first again at the end where the chain is closed
  std::size_t firstSegment = 0;  ///< the smallest index of its segments
};

/// Joins segments wherever two of them, and no more, meet in a point. A chain runs in the direction
/// of its first segment; chains come in the order of their first segments.
std::vector<SegmentChain> chainSegments(const std::vector<std::array<vtkIdType, 2>>& segments);
}
}
