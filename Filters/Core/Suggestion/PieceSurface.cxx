// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/PieceSurface.h"

#include "Suggestion/SurfaceCoarsening.h"

#include <array>

namespace flattening
{
namespace
{
/// How near the middle of a piece's area is to that of its image, in sqrt(area / pi) of the
/// surface, and how much areas may differ.
constexpr double sameMiddle = 1e-5;
/// The same of what is nearly its image, and how far 95 % of its points may be from that, in
/// sqrt(area / pi) of the piece.
constexpr double nearImage = 0.1;

/// Where the curves of a surface run.
struct CurvesOnPieces
{
  CurvesOnPieces(const ImprintedSurface& surface, const std::vector<Piece>& all)
    : pieces(surface.mesh.triangleCount(), none)
    , local(surface.mesh.triangleCount(), none)
    , curves(all.size())
  {
    for (std::size_t p = 0; p < all.size(); ++p)
    {
      for (std::size_t t = 0; t < all[p].triangles.size(); ++t)
      {
        this->pieces[all[p].triangles[t]] = static_cast<Index>(p);
        this->local[all[p].triangles[t]] = static_cast<Index>(t);
      }
    }
    for (Index c = 0; c < static_cast<Index>(surface.curves.size()); ++c)
    {
      for (std::vector<Indices>& side : this->halfedges)
      {
        side.emplace_back();
      }
      forEachEdge(surface.curves[c].vertices, [&](Index a, Index b) {
        this->halfedges[0][c].push_back(surface.mesh.find(a, b));
        this->halfedges[1][c].push_back(surface.mesh.find(b, a));
        for (const std::vector<Indices>& side : this->halfedges)
        {
          const Index h = side[c].back();
          Indices* const there = h == none ? nullptr : &this->curves[this->pieces[h / 3]];
          if (there && (there->empty() || there->back() != c))
          {
            there->push_back(c);
          }
        }
      });
    }
  }

  Indices pieces;                                ///< by triangle
  Indices local;                                 ///< by triangle, its id in its piece
  std::array<std::vector<Indices>, 2> halfedges; ///< along and against each curve; or none
  std::vector<Indices> curves;                   ///< by piece, ascending
};

/// The stretches of curves with piece p on their left, or of those with none on their left on their
/// right.
std::vector<FeatureCurve> stretchesOn(
  const ImprintedSurface& surface, const CurvesOnPieces& on, const Piece& piece, Index p)
{
  std::vector<FeatureCurve> found;
  const auto add = [&found](const FeatureCurve& curve, std::size_t k, Index vertex) {
    found.back().vertices.push_back(vertex);
    if (k < curve.planarShape.size())
    {
      found.back().planarShape.push_back(curve.planarShape[k]);
    }
  };
  const auto follow = [&](Index c, bool forward) {
    const FeatureCurve& curve = surface.curves[c];
    Index last = none;
    for (std::size_t k = 1; k < curve.vertices.size(); ++k)
    {
      const Index here = on.halfedges[forward ? 0 : 1][c][k - 1];
      const Index h =
        here == none || on.pieces[here / 3] != p ? none : 3 * on.local[here / 3] + here % 3;
      const bool bounds = h != none && piece.mesh.twin(h) == none;
      if (h == none || (!forward && !bounds) || (curve.opens() && bounds && curve.tolerance == 0.0))
      {
        last = none;
        continue;
      }
      const Index from = forward ? piece.mesh.from(h) : piece.mesh.to(h);
      const Index to = forward ? piece.mesh.to(h) : piece.mesh.from(h);
      const CurveType type = curve.opens() && bounds ? CurveType::Accessory : curve.type;
      if (last != from || found.back().type != type)
      {
        found.push_back({ curve.name, type, curve.keyShape, curve.tolerance, {}, {}, {} });
        add(curve, k - 1, from);
      }
      add(curve, k, to);
      last = to;
    }
  };
  for (const Index c : on.curves[p])
  {
    follow(c, true);
    follow(c, false);
  }
  return found;
}
}

std::vector<Polyline> PieceSurface::polylines() const
{
  std::vector<Polyline> lines;
  for (const FeatureCurve& curve : this->curves)
  {
    lines.push_back(
      { curve.name, curve.type, curve.keyShape, curve.tolerance, {}, {}, curve.planarShape, {} });
    for (Index v : curve.vertices)
    {
      lines.back().points.push_back(this->mesh.point(v));
    }
  }
  return lines;
}

std::vector<PieceSurface> pieceSurfaces(
  const ImprintedSurface& surface, const CutSurface& cut, const RegionWeights& weights)
{
  CurveLabels between;
  between.opens = { 1 };
  between.curveOfHalfedge.assign(surface.mesh.halfedgeCount(), none);
  for (Index h = 0; h < surface.mesh.halfedgeCount(); ++h)
  {
    const Index twin = surface.mesh.twin(h);
    if (twin != none && cut.pieceOfTriangle[h / 3] != cut.pieceOfTriangle[twin / 3])
    {
      between.curveOfHalfedge[h] = 0;
    }
  }
  const CutSurface opened = openCuts(surface.mesh, std::move(between));
  std::vector<PieceSurface> result;
  std::vector<Piece> pieces = extractPieces(opened);
  const CurvesOnPieces on(surface, pieces);
  for (Piece& piece : pieces)
  {
    PieceSurface one;
    one.curves = stretchesOn(surface, on, piece, static_cast<Index>(result.size()));
    for (Index v : piece.vertices)
    {
      one.vertices.push_back(opened.originalVertex[v]);
    }
    for (std::size_t t = 0; t < piece.triangles.size() && !weights.empty(); ++t)
    {
      one.weights.push_back(weights[surface.originalTriangle[piece.triangles[t]]]);
    }
    one.mesh = std::move(piece.mesh);
    result.push_back(std::move(one));
  }
  return result;
}

PieceSurface coarsened(const PieceSurface& piece, Index triangles)
{
  if (piece.mesh.triangleCount() <= triangles)
  {
    return piece;
  }
  std::vector<char> kept(piece.mesh.vertexCount(), 0);
  for (const FeatureCurve& curve : piece.curves)
  {
    for (Index v : curve.vertices)
    {
      kept[v] = 1;
    }
  }
  CoarseSurface coarse = coarsened(piece.mesh, std::move(kept), triangles);
  Indices number(piece.mesh.vertexCount(), none);
  PieceSurface result;
  for (std::size_t v = 0; v < coarse.vertices.size(); ++v)
  {
    number[coarse.vertices[v]] = static_cast<Index>(v);
    result.vertices.push_back(piece.vertices[coarse.vertices[v]]);
  }
  result.mesh = std::move(coarse.mesh);
  result.weights = resampledWeights(piece.mesh, piece.weights, result.mesh);
  result.curves = piece.curves;
  for (FeatureCurve& curve : result.curves)
  {
    for (Index& v : curve.vertices)
    {
      v = number[v];
    }
  }
  return result;
}

Indices pieceImages(const std::vector<PieceSurface>& pieces,
  const std::optional<SurfaceMirror>& mirror, double size, bool nearly)
{
  Indices images(pieces.size(), none);
  const bool exact = mirror && mirror->error <= SurfaceMirror::exact;
  if (!mirror || !mirror->plane() || (!exact && !nearly))
  {
    return images;
  }
  std::vector<SurfaceMoments> moments;
  for (const PieceSurface& piece : pieces)
  {
    moments.push_back(momentsOf(piece.mesh));
  }
  const auto distance = [&](std::size_t p, std::size_t q) {
    return (mirror->mirrored(moments[p].center) - moments[q].center).norm();
  };
  const auto near = [&](std::size_t p, std::size_t q) {
    return measuredPlane(pieces[p].mesh, pieces[q].mesh, *mirror->plane()).spread < nearImage;
  };
  const auto alike = [&](std::size_t p, std::size_t q) {
    if (!exact)
    {
      return pieces[p].curves.size() == pieces[q].curves.size() &&
        distance(p, q) < nearImage * std::sqrt(moments[p].area) && near(p, q) && near(q, p);
    }
    return pieces[p].mesh.triangleCount() == pieces[q].mesh.triangleCount() &&
      pieces[p].curves.size() == pieces[q].curves.size() && distance(p, q) < sameMiddle * size &&
      std::abs(moments[p].area - moments[q].area) < sameMiddle * size * size;
  };
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    // Of several in one place each has its own.
    for (std::size_t q = p; q < pieces.size() && images[p] == none; ++q)
    {
      if (images[q] == none && alike(p, q))
      {
        images[p] = static_cast<Index>(q);
        images[q] = static_cast<Index>(p);
      }
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
    lines.back().points = mirror.mirrored(std::move(lines.back().points));
  }
  return lines;
}
}
