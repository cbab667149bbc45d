// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/PieceImages.h"

#include "Suggestion/SurfaceMoments.h"

namespace flattening
{
namespace
{
/// How near the middle of a piece's area is to that of its image, in sqrt(area / pi) of the
/// surface, and how much areas may differ.
constexpr double sameMiddle = 1e-5;
}

Indices pieceImages(
  const std::vector<PieceSurface>& pieces, const std::optional<SurfaceMirror>& mirror, double size)
{
  Indices images(pieces.size(), none);
  if (!mirror || !mirror->plane() || mirror->error > SurfaceMirror::exact)
  {
    return images;
  }
  std::vector<SurfaceMoments> moments;
  for (const PieceSurface& piece : pieces)
  {
    moments.push_back(momentsOf(piece.mesh));
  }
  const auto alike = [&](std::size_t p, std::size_t q) {
    return pieces[p].mesh.triangleCount() == pieces[q].mesh.triangleCount() &&
      pieces[p].curves.size() == pieces[q].curves.size() &&
      (mirror->mirrored(moments[p].center) - moments[q].center).norm() < sameMiddle * size &&
      std::abs(moments[p].area - moments[q].area) < sameMiddle * size * size;
  };
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (std::size_t q = 0; q < pieces.size() && !alike(p, p); ++q)
    {
      images[p] = q != p && alike(p, q) ? static_cast<Index>(q) : images[p];
    }
  }
  return images;
}

std::vector<Polyline> withImages(std::vector<Polyline> lines, const SurfaceMirror& mirror)
{
  const std::size_t count = lines.size();
  for (std::size_t k = 0; k < count; ++k)
  {
    lines.push_back(lines[k]);
    for (Point3& point : lines.back().points)
    {
      point = mirror.mirrored(point);
    }
  }
  return lines;
}
}
