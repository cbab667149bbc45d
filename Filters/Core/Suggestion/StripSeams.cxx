// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/StripSeams.h"

#include "Cut/SurfaceCut.h"
#include "Flattening/PieceArrangement.h"
#include "Paths/PlaneSection.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/PieceSurface.h"
#include "Suggestion/SeamSettling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{
/// A width that is greater by less than this share of it is rounding.
constexpr double rounding = 1e-6;
/// Pieces are parted into strips this often at most.
constexpr int maxStrippings = 3;
/// Of the width allowed, that of strips: they are flattened anew and may come out a little wider.
constexpr std::array<double, 3> stripShares{ 1.0, 0.97, 0.9 };

Points2 flatPoints(const Piece& piece, const Points2& positions)
{
  Points2 points;
  for (Index v : piece.vertices)
  {
    points.push_back(positions[v]);
  }
  return points;
}

/// The width of the widest piece.
double greatestWidth(const CutTrials::Trial& flat, double allowed)
{
  double greatest = 0.0;
  for (const Piece& piece : extractPieces(*flat.flat.cut))
  {
    greatest = std::max(greatest, leastWidth(flatPoints(piece, flat.flat.positions)).width);
  }
  return greatest <= (1.0 + rounding) * allowed ? std::min(greatest, allowed) : greatest;
}

/// \param size of the surface, sqrt(area / pi)
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
        Points3 seam;
        for (const SurfacePoint& place : section.path.points)
        {
          const TriangleMesh& piece = pieces[p].mesh;
          const bool vertex = place.type == SurfacePointType::Vertex;
          seam.push_back(
            vertex ? piece.point(place.id) : edgePoint(piece, place.id, place.weights[1]).position);
        }
        cuts.push_back(proposedCut(std::move(seam)));
      }
    }
    if (images[p] != none && images[p] != static_cast<Index>(p))
    {
      done[images[p]] = 1;
      addImages(cuts, before, *mirror);
    }
  }
}
}

CutSet inStrips(CutSet set, const SearchSubject& subject, TrialBudget& budget,
  const Execution& execution, double& width)
{
  const CutTrials trials(subject.mesh, subject.curves, subject.imprint, subject.flattening,
    subject.goal, subject.weights);
  const double most = subject.search.maximumWidth;
  CutTrials::Trial flat = trials.trial(linesOf(set.cuts), budget, execution);
  width = flat.outcome.valid ? greatestWidth(flat, most) : 0.0;
  for (int k = 0; k < maxStrippings && width > most; ++k)
  {
    const CutTrials::Trial before = flat;
    const CutSet wide = set;
    for (std::size_t s = 0; s < stripShares.size() && width > most; ++s)
    {
      CutSet next = wide;
      addStripSeams(before, stripShares[s] * most, subject.mirror,
        std::sqrt(subject.mesh.area() / pi), next.cuts);
      openDividingDarts(subject.mesh, subject.curves, subject.imprint, next.cuts);
      if (static_cast<double>(next.cuts.size()) > maxChartCuts ||
        !keepsLimits(next, subject.search))
      {
        return set;
      }
      CutTrials::Trial after = trials.trial(linesOf(next.cuts), budget, execution);
      if (after.outcome.soundAfter(wide.outcome))
      {
        flat = std::move(after);
        width = greatestWidth(flat, most);
        set = std::move(next);
        set.outcome = flat.outcome;
      }
    }
  }
  return set;
}
}
