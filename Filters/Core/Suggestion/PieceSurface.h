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

/// By piece the one that is its image in a plane, with as many curves: itself, or another, as of
/// the halves of what is cut along it; none where there is none.
/// \param size of the surface, sqrt(area / pi)
/// \param nearly whether images that are not exact are such, too
Indices pieceImages(const std::vector<PieceSurface>& pieces,
  const std::optional<SurfaceMirror>& mirror, double size, bool nearly = false);

/// The lines and their images.
std::vector<Polyline> withImages(std::vector<Polyline> lines, const SurfaceMirror& mirror);
}
