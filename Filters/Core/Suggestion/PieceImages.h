// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/PieceSurface.h"
#include "Suggestion/SurfaceMirror.h"

#include <optional>

namespace flattening
{
/// By piece the other one that is its exact image in a plane, as the halves of what is cut along
/// it, with as many curves; none where there is none, and where a piece is its own image.
/// \param size of the surface, sqrt(area / pi)
Indices pieceImages(
  const std::vector<PieceSurface>& pieces, const std::optional<SurfaceMirror>& mirror, double size);

/// The lines and their images.
std::vector<Polyline> withImages(std::vector<Polyline> lines, const SurfaceMirror& mirror);
}
