// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/StripSeams.h"

#include "Cut/SurfaceCut.h"
#include "Flattening/PieceArrangement.h"
#include "Paths/PlaneSection.h"
#include "Suggestion/PieceSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{
/// A width that is greater by less than this share of it is rounding.
constexpr double rounding = 1e-6;

Points2 flatPoints(const Piece& piece, const Points2& positions)
{
  Points2 points;
  for (Index v : piece.vertices)
  {
    points.push_back(positions[v]);
  }
  return points;
}

/// The place on the surface of a place on a flat piece.
Point3 onSurface(const TriangleMesh& piece, const SurfacePoint& place)
{
  switch (place.type)
  {
    case SurfacePointType::Vertex:
      return piece.point(place.id);
    case SurfacePointType::Edge:
      return place.weights[0] * piece.point(piece.from(place.id)) +
        place.weights[1] * piece.point(piece.to(place.id));
    default:
      break;
  }
  Point3 point = Point3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
  {
    point += place.weights[k] * piece.point(piece.triangle(place.id)[k]);
  }
  return point;
}
}

double greatestWidth(const CutTrials::Trial& flat, double allowed)
{
  double greatest = 0.0;
  for (const Piece& piece : extractPieces(*flat.flat.cut))
  {
    greatest = std::max(greatest, leastWidth(flatPoints(piece, flat.flat.positions)).width);
  }
  return greatest <= (1.0 + rounding) * allowed ? std::min(greatest, allowed) : greatest;
}

void addStripSeams(const CutTrials::Trial& flat, double maximumWidth,
  const std::optional<SurfaceMirror>& mirror, double size, std::vector<SuggestedCurve>& cuts)
{
  const std::vector<Piece> pieces = extractPieces(*flat.flat.cut);
  const Indices images = pieceImages(pieceSurfaces(flat.surface, *flat.flat.cut), mirror, size);
  std::vector<char> done(pieces.size(), 0);
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const Points2 points = flatPoints(pieces[p], flat.flat.positions);
    const LeastWidth least = leastWidth(points);
    if (done[p] || least.width <= (1.0 + rounding) * maximumWidth)
    {
      continue;
    }
    Points3 raised;
    double low = std::numeric_limits<double>::infinity();
    for (const Point2& point : points)
    {
      raised.emplace_back(point.x(), point.y(), 0.0);
      low = std::min(low, least.across.dot(point));
    }
    const TriangleMesh plane(std::move(raised), pieces[p].mesh.triangles());
    const Point3 across(least.across.x(), least.across.y(), 0.0);
    const auto before = static_cast<Index>(cuts.size());
    const double strips = std::ceil(least.width / maximumWidth - rounding);
    for (double k = 1.0; k < strips; ++k)
    {
      for (const PlaneSection& section :
        planeSections(plane, (low + k * least.width / strips) * across, across))
      {
        if (section.closed || section.path.points.size() < 2)
        {
          continue;
        }
        SuggestedCurve seam;
        seam.curve.type = CurveType::Seam;
        for (const SurfacePoint& place : section.path.points)
        {
          seam.curve.points.push_back(onSurface(pieces[p].mesh, place));
        }
        seam.length = lengthOf(seam.curve.points);
        cuts.push_back(std::move(seam));
      }
    }
    if (images[p] != none)
    {
      done[images[p]] = 1;
      addImages(cuts, before, *mirror);
    }
  }
}
}
