// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/OffsetWindow.h"
#include "Paths/PathGraph.h"
#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// A piece of an offset in one triangle: a straight one, or an arc as tangents to it.
struct OffsetLine
{
  Index triangle = none;
  std::vector<SurfacePoint> points;
};

/// Where the windows on the side that is asked for end, without what is nearer in any other
/// window; in the order of the windows, the path on their right.
std::vector<OffsetLine> offsetLines(
  const TriangleMesh& mesh, const std::vector<OffsetWindow>& windows, double distance);

/// Lines of which one starts where another ends are one path. Those that are over after a
/// millionth of the distance are left out.
std::vector<SurfacePath> joined(
  const PathGraph& graph, const std::vector<OffsetLine>& lines, double distance);
}
