// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"
#include "Imprint/ImprintedSurface.h"
#include "Suggestion/SurfaceMirror.h"
#include "Surface/RegionWeights.h"

#include <optional>

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

/// The same with about this number of triangles, where it has more; boundary and curves stay.
PieceSurface coarsened(const PieceSurface& piece, Index triangles);

/// By piece the other one that is its exact image in a plane, as the halves of what is cut along
/// it, with as many curves; none where there is none, and where a piece is its own image.
/// \param size of the surface, sqrt(area / pi)
Indices pieceImages(
  const std::vector<PieceSurface>& pieces, const std::optional<SurfaceMirror>& mirror, double size);

/// The lines and their images.
std::vector<Polyline> withImages(std::vector<Polyline> lines, const SurfaceMirror& mirror);
}
