// SPDX-License-Identifier: BSD-3-Clause
#include "Cut/SurfaceCut.h"

#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{
std::string curveName(const FeatureCurve& curve, std::size_t id)
{
  return curve.name.empty() ? "curve " + std::to_string(id) : "curve \"" + curve.name + "\"";
}

ElementIds ofCurve(std::size_t id)
{
  return { ElementKind::Curves, Indices{ static_cast<Index>(id) } };
}

/// What the stages after the cut take for granted of a curve's properties.
Status checkProperties(const FeatureCurve& curve, std::size_t id)
{
  if (curve.type < CurveType::Accessory || curve.type > CurveType::Seam)
  {
    return { StatusCode::InvalidCurve,
      curveName(curve, id) + " has the unknown type " +
        std::to_string(static_cast<int>(curve.type)),
      ofCurve(id), { { Remedy::Give, "0 (accessory), 1 (key), 2 (dart) or 3 (seam)" } } };
  }
  if (!std::isfinite(curve.tolerance) || curve.tolerance < 0.0 || curve.tolerance >= 1.0)
  {
    return { StatusCode::InvalidCurve,
      curveName(curve, id) + " has a length tolerance outside 0..1", ofCurve(id),
      { { Remedy::Give, "a fraction of its length" } } };
  }
  if (curve.type == CurveType::Key && curve.keyShape == KeyShape::Planar)
  {
    // Up to 1e300 differences are finite as well.
    const auto usable = [](double x) { return std::isfinite(x) && std::abs(x) <= 1e300; };
    const auto finite = [&usable](const Point2& p) { return usable(p.x()) && usable(p.y()); };
    if (curve.planarShape.size() != curve.vertices.size() ||
      !std::all_of(curve.planarShape.begin(), curve.planarShape.end(), finite))
    {
      return { StatusCode::InvalidCurve,
        curveName(curve, id) + " has a planar shape of " +
          std::to_string(curve.planarShape.size()) + " points for " +
          std::to_string(curve.vertices.size()) +
          " vertices, or a coordinate that is not a number or beyond 1e300",
        ofCurve(id), { { Remedy::Give, "a finite point for each" } } };
    }
    const auto same = std::adjacent_find(curve.planarShape.begin(), curve.planarShape.end());
    if (same != curve.planarShape.end())
    {
      return { StatusCode::InvalidCurve,
        curveName(curve, id) +
          " has a planar shape with successive points in one place, which make no angle",
        ofCurve(id), { Remedy::SpreadPlanarShape } };
    }
  }
  return {};
}

Status followCurves(
  const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves, Indices& curveOfHalfedge)
{
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const Indices& chain = curves[c].vertices;
    if (chain.size() < 2)
    {
      return { StatusCode::CurveTooShort, curveName(curves[c], c) + " has fewer than two points",
        { ElementKind::Points, chain }, { Remedy::RedrawCurve } };
    }
    for (Index v : chain)
    {
      if (v < 0 || v >= mesh.vertexCount())
      {
        return { StatusCode::InvalidPointId,
          curveName(curves[c], c) + " uses vertex " + std::to_string(v) +
            ", which the surface does not have",
          { ElementKind::Points, Indices{ v } }, { Remedy::WriteAgain } };
      }
    }
    Status properties = checkProperties(curves[c], c);
    if (!properties.ok())
    {
      return properties;
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    {
      const Index forward = mesh.find(chain[i], chain[i + 1]);
      const Index backward = mesh.find(chain[i + 1], chain[i]);
      if (forward == none && backward == none)
      {
        return { StatusCode::CurveNotOnEdges,
          curveName(curves[c], c) +
            " has a segment that is not an edge of the mesh, between vertices " +
            std::to_string(chain[i]) + " and " + std::to_string(chain[i + 1]),
          { ElementKind::Edges, Indices{ chain[i], chain[i + 1] } },
          { Remedy::SplitTriangles, Remedy::FollowEdges } };
      }
      for (Index h : { forward, backward })
      {
        if (h == none)
        {
          continue;
        }
        Index& label = curveOfHalfedge[h];
        // By the order of types: seam before dart, key and accessory.
        if (label == none || curves[c].type > curves[label].type)
        {
          label = static_cast<Index>(c);
        }
      }
    }
  }
  return {};
}
}

CurveLabels labelHalfedges(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves)
{
  CurveLabels labels;
  if (mesh.triangleCount() == 0)
  {
    labels.status = { StatusCode::EmptySurface, "the surface has no triangles", {},
      { Remedy::GiveTriangles } };
    return labels;
  }
  labels.curveOfHalfedge.assign(mesh.halfedgeCount(), none);
  for (const FeatureCurve& curve : curves)
  {
    labels.opens.push_back(curve.opens());
  }
  labels.status = followCurves(mesh, curves, labels.curveOfHalfedge);
  return labels;
}

CutSurface cutSurface(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves)
{
  CurveLabels labels = labelHalfedges(mesh, curves);
  if (!labels.status.ok())
  {
    CutSurface cut;
    cut.status = std::move(labels.status);
    return cut;
  }
  return openCuts(mesh, std::move(labels));
}

namespace
{
/// Gives the fans between cuts a vertex each.
TriangleMesh opened(const TriangleMesh& mesh, const CurveLabels& labels, Indices& originalVertex)
{
  // Crossing an uncut edge keeps a fan's copy of the vertex, so copies are the fans between cuts.
  auto crossing = [&](Index h) { return mesh.twin(h) == none || labels.opensAt(h); };
  Points3 points = mesh.points();
  Triangles triangles = mesh.triangles();
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    // Start behind a cut or at the boundary, so that no fan is met in two parts.
    Index start = none;
    for (Index h : VertexFan(mesh, v))
    {
      if (crossing(h))
      {
        start = h;
        break;
      }
    }
    if (start == none)
    {
      continue;
    }
    Index copy = v;
    bool firstFan = true;
    for (Index h : VertexFan::startingAt(mesh, start))
    {
      if (crossing(h) && !firstFan)
      {
        copy = static_cast<Index>(points.size());
        points.push_back(mesh.point(v));
        originalVertex.push_back(v);
      }
      firstFan = false;
      triangles[h / 3][h % 3] = copy;
    }
  }
  // Half-edges are twins still unless an end of their edge is split. A cut of a single edge inside
  // the surface has nothing to open.
  Indices twins(mesh.halfedgeCount(), none);
  const auto corner = [&triangles](Index h) { return triangles[h / 3][h % 3]; };
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    const Index twin = mesh.twin(h);
    if (twin > h && corner(h) == corner(TriangleMesh::next(twin)) &&
      corner(twin) == corner(TriangleMesh::next(h)))
    {
      twins[h] = twin;
      twins[twin] = h;
    }
  }
  points.shrink_to_fit(); // it grew by copies, and is kept
  return TriangleMesh(std::move(points), std::move(triangles), std::move(twins));
}
}

CutSurface openCuts(const TriangleMesh& mesh, CurveLabels labels)
{
  CutSurface cut;
  cut.originalVertex.resize(mesh.vertexCount());
  std::iota(cut.originalVertex.begin(), cut.originalVertex.end(), 0);
  cut.originalVertexCount = mesh.vertexCount();
  const bool opens = std::any_of(labels.curveOfHalfedge.begin(), labels.curveOfHalfedge.end(),
    [&labels](Index curve) { return curve != none && labels.opens[curve] != 0; });
  cut.mesh = opens ? opened(mesh, labels, cut.originalVertex) : mesh;
  cut.curveOfHalfedge = std::move(labels.curveOfHalfedge);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) > h && cut.mesh.twin(h) == none)
    {
      cut.seamPairs.push_back({ h, mesh.twin(h), cut.curveOfHalfedge[h] });
    }
  }
  cut.pieceCount = connectedParts(cut.mesh, {}, cut.pieceOfTriangle);
  return cut;
}

std::vector<Piece> extractPieces(const CutSurface& cut)
{
  std::vector<Piece> pieces(cut.pieceCount);
  std::vector<Triangles> triangles(cut.pieceCount);
  std::vector<Points3> points(cut.pieceCount);
  Indices sizes(cut.pieceCount, 0);
  for (Index p : cut.pieceOfTriangle)
  {
    ++sizes[p];
  }
  const Index only = cut.pieceCount == 1 ? cut.mesh.vertexCount() : 0;
  for (Index p = 0; p < cut.pieceCount; ++p)
  {
    points[p].reserve(only);
    pieces[p].vertices.reserve(only);
    triangles[p].reserve(sizes[p]);
    pieces[p].triangles.reserve(sizes[p]);
    pieces[p].curveOfHalfedge.reserve(3 * std::size_t(sizes[p]));
  }
  Indices local(cut.mesh.vertexCount(), none);
  Indices localTriangle(cut.mesh.triangleCount(), none);
  for (Index t = 0; t < cut.mesh.triangleCount(); ++t)
  {
    const Index p = cut.pieceOfTriangle[t];
    Triangle corners{};
    for (int k = 0; k < 3; ++k)
    {
      const Index v = cut.mesh.triangle(t)[k];
      if (local[v] == none)
      {
        local[v] = static_cast<Index>(points[p].size());
        points[p].push_back(cut.mesh.point(v));
        pieces[p].vertices.push_back(v);
      }
      corners[k] = local[v];
      pieces[p].curveOfHalfedge.push_back(cut.curveOfHalfedge[3 * t + k]);
    }
    localTriangle[t] = static_cast<Index>(triangles[p].size());
    triangles[p].push_back(corners);
    pieces[p].triangles.push_back(t);
  }
  for (Index p = 0; p < cut.pieceCount; ++p)
  {
    Indices twins;
    twins.reserve(3 * pieces[p].triangles.size());
    for (Index t : pieces[p].triangles)
    {
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Index twin = cut.mesh.twin(h);
        twins.push_back(twin == none ? none : 3 * localTriangle[twin / 3] + twin % 3);
      }
    }
    points[p].shrink_to_fit();
    pieces[p].vertices.shrink_to_fit();
    pieces[p].mesh = TriangleMesh(std::move(points[p]), std::move(triangles[p]), std::move(twins));
  }
  return pieces;
}

namespace
{
/// How many cuts run through each vertex.
Indices countCuts(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves)
{
  Indices cuts(mesh.vertexCount(), 0);
  for (const FeatureCurve& curve : curves)
  {
    if (curve.opens())
    {
      Indices own = curve.vertices;
      sortUnique(own);
      for (const Index v : own)
      {
        ++cuts[v];
      }
    }
  }
  return cuts;
}

/// Turns the least from the edge before -> end.
Index boundaryNeighbour(const TriangleMesh& mesh, Index before, Index end)
{
  const Point3 along = (mesh.point(end) - mesh.point(before)).normalized();
  Index best = none;
  double bestCosine = -2.0;
  for (const Index h : VertexFan(mesh, end)) // inside, so that all neighbours are met
  {
    const Index to = mesh.to(h);
    const double cosine = along.dot((mesh.point(to) - mesh.point(end)).normalized());
    if (mesh.onBoundary(to) && cosine > bestCosine)
    {
      best = to;
      bestCosine = cosine;
    }
  }
  return best;
}
}

std::vector<ShortEnd> endsShortOfBoundary(
  const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves)
{
  std::vector<ShortEnd> ends;
  const Indices cuts = countCuts(mesh, curves);
  const auto reaches = [&](Index v) { return mesh.onBoundary(v) || cuts[v] > 1; };
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const Indices& chain = curves[c].vertices;
    if (!curves[c].opens() || curves[c].closed() || chain.size() < 2)
    {
      continue;
    }
    const bool dart = curves[c].type == CurveType::Dart;
    if (dart && (reaches(chain.front()) || reaches(chain.back())))
    {
      continue;
    }
    std::vector<ShortEnd> found;
    for (const auto& [before, end] :
      { std::pair{ chain[1], chain.front() }, std::pair{ chain[chain.size() - 2], chain.back() } })
    {
      const Index boundary = reaches(end) ? none : boundaryNeighbour(mesh, before, end);
      if (boundary != none)
      {
        found.push_back({ static_cast<Index>(c), end, boundary });
      }
    }
    const auto distance = [&mesh](const ShortEnd& e) {
      return (mesh.point(e.boundary) - mesh.point(e.vertex)).squaredNorm();
    };
    if (dart && found.size() == 2)
    {
      found.erase(found.begin() + (distance(found[1]) < distance(found[0]) ? 0 : 1));
    }
    ends.insert(ends.end(), found.begin(), found.end());
  }
  return ends;
}
}
