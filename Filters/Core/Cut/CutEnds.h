// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/FeatureCurve.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// An end of a dart or seam one edge inside the boundary, which was likely meant to lie on it.
struct ShortEnd
{
  Index curve = none;
  Index vertex = none;   ///< the end
  Index boundary = none; ///< its neighbour on the boundary that continues the curve best
};

/// Ends of cuts that stop one edge short of the boundary: of a seam each that lies neither on the
/// boundary nor on another cut, of a dart the nearer one where both are so, since its tip is free.
/// \pre the curves run along edges of the mesh.
std::vector<ShortEnd> endsShortOfBoundary(
  const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves);
}
