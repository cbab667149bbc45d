// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfaceTrace.h"

#include <vector>

namespace flattening
{
/// A place on one of several paths.
struct PathPlace
{
  std::size_t path = 0;
  std::size_t leg = 0;
  double along = 0.0; ///< fraction of the leg
};

/// Where two legs of one triangle cross.
struct PathCrossing
{
  PathPlace first;
  PathPlace second;
  SurfacePoint point;
  double turn =
    0.0; ///< sine of the angle from the first leg to the second, anti-clockwise positive
};

/// Those of the first `count` paths with themselves, with each other, and with the other paths;
/// neighbours along a path do not count. Crossings on an edge of the mesh may come once from each
/// side; those at its vertices are found where two legs are in one triangle.
std::vector<PathCrossing> pathCrossings(
  const TriangleMesh& mesh, const std::vector<SurfacePath>& paths, std::size_t count);
}
