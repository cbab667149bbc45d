// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"
#include "Imprint/ImprintedSurface.h"
#include "Suggestion/RegionWeights.h"

namespace flattening
{
/// A piece as it was before darts were opened in it, with the stretches of curves that it has: a
/// surface that flattens as the piece does.
struct PieceSurface
{
  TriangleMesh mesh;
  Indices vertices; ///< per vertex its id in the surface that the piece is of
  /// Along edges. Cuts that bound the piece are left out, unless they are elastic.
  std::vector<FeatureCurve> curves;
  RegionWeights weights;

  std::vector<Polyline> polylines() const;
};

/// One for each piece of the cut surface, in their order. \param weights of the surface before its
/// curves were imprinted
std::vector<PieceSurface> pieceSurfaces(
  const ImprintedSurface& surface, const CutSurface& cut, const RegionWeights& weights = {});

/// The same with about so many triangles, where it has more; boundary and curves stay as they are.
PieceSurface coarsened(const PieceSurface& piece, Index triangles);
}
