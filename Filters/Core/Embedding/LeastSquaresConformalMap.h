// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Base/Execution.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Angles and lengths of the wires in a least squares conformal map of the piece, to start from
/// where the plain start fails; those on the surface where there is no such map.
AngleStart conformalStart(
  const Piece& piece, const WireNetwork& network, const Execution& execution);

struct LeastSquaresConformalOptions
{
  /// The two vertices that are pinned; none: the two boundary vertices that are farthest apart in
  /// space.
  std::array<Index, 2> pins{ none, none };
  /// Divide each triangle's rows by the root of its area, as Levy et al. do. Off, large triangles
  /// count more.
  bool areaNormalized = true;
};

struct LeastSquaresConformalMap
{
  Points2 positions;
  Status status;
};

/// Least squares conformal map of a disk-like surface (Levy, Petitjean, Ray, Maillot, "Least
/// squares conformal maps for automatic texture atlas generation", ACM TOG 21(3), 2002), scaled so
/// that its perimeter is that of the surface, as the paper does for comparison.
/// Errors: ClosedSurface, InvalidOption (pins), NumericalFailure, Cancelled.
LeastSquaresConformalMap leastSquaresConformalMap(const TriangleMesh& mesh,
  const LeastSquaresConformalOptions& options, const Execution& execution = {});
}
