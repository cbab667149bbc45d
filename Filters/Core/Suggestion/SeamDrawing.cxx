// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SeamDrawing.h"

#include "Paths/PathFitting.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

namespace flattening
{
namespace
{
/// Places this near to vertices, in mean edges, are moved onto them.
constexpr double placeSnap = 0.03;
/// In mean edges, points of a line are farther apart.
constexpr double minStep = 0.02;
/// By level, how far lines go from their chains, in the longest steps of these.
constexpr std::array<double, SeamDrawing::levels> farthest{ std::numeric_limits<double>::infinity(),
  3.0, 1.0, 0.4, 0.0 };

/// Sets of curves that meet elsewhere than at ends of all of them, that run along the boundary, or
/// of which one is a dart whose tip, its last point, is on others.
std::vector<Indices> meetingCurves(const ImprintedSurface& surface)
{
  std::set<Indices> sets;
  std::vector<Indices> through(surface.mesh.vertexCount());
  std::vector<char> inside(surface.mesh.vertexCount(), 0);
  std::map<Indices, Index> owner; // by the ends of an edge
  for (std::size_t c = 0; c < surface.curves.size(); ++c)
  {
    const Indices& vertices = surface.curves[c].vertices;
    for (std::size_t k = 1; k < vertices.size(); ++k)
    {
      const auto [a, b] = std::minmax(vertices[k - 1], vertices[k]);
      const auto entry = owner.emplace(Indices{ a, b }, static_cast<Index>(c));
      const Index h = surface.mesh.find(a, b);
      if (!entry.second || h == none || surface.mesh.twin(h) == none)
      {
        sets.insert({ entry.first->second, static_cast<Index>(c) });
      }
    }
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
      const bool tip = k + 1 == vertices.size() && surface.curves[c].type == CurveType::Dart;
      const bool inner = (k > 0 && k + 1 < vertices.size()) || tip;
      through[vertices[k]].push_back(static_cast<Index>(c));
      inside[vertices[k]] = inside[vertices[k]] || inner ? 1 : 0;
      if (inner && surface.mesh.onBoundary(vertices[k]))
      {
        sets.insert({ static_cast<Index>(c) });
      }
    }
  }
  for (std::size_t v = 0; v < through.size(); ++v)
  {
    if (inside[v] && through[v].size() > 1)
    {
      sets.insert(through[v]);
    }
  }
  return { sets.begin(), sets.end() };
}
}

bool isCrease(const TriangleMesh& mesh, Index halfedge, double cosine)
{
  const Index twin = mesh.twin(halfedge);
  return twin != none &&
    triangleNormal(mesh, halfedge / 3).dot(triangleNormal(mesh, twin / 3)) < cosine;
}

std::vector<char> creasesOf(const TriangleMesh& mesh, double cosine)
{
  std::vector<char> creases(mesh.halfedgeCount(), 0);
  std::vector<char> on(mesh.vertexCount(), 0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    creases[h] = isCrease(mesh, h, cosine) ? 1 : 0;
    on[mesh.from(h)] = on[mesh.from(h)] || creases[h] ? 1 : 0;
  }
  if (2 * std::count(on.begin(), on.end(), 1) > mesh.vertexCount())
  {
    creases.assign(creases.size(), 0);
  }
  return creases;
}

SeamDrawing::SeamDrawing(const TriangleMesh& mesh)
  : Mesh(mesh)
  , Graph(mesh)
  , Locator(mesh)
  , Snap(mesh, placeSnap)
{
}

std::vector<SurfacePoint> SeamDrawing::place(const Points3& line) const
{
  std::vector<SurfacePoint> places;
  for (const SheetLocator::Place& place : this->Locator.along(line))
  {
    places.push_back(snapToMesh(this->Mesh, this->Snap, place.closest));
  }
  return places;
}

std::vector<SurfacePoint> SeamDrawing::imageOn(const SeamDrawing& other,
  const std::vector<SurfacePoint>& chain, const SymmetryPlane& plane) const
{
  const auto onBoundary = [this](const SurfacePoint& place) {
    return place.type == SurfacePointType::Vertex
      ? this->Mesh.onBoundary(place.id)
      : place.type == SurfacePointType::Edge && this->Mesh.twin(place.id) == none;
  };
  Points3 images;
  for (const SurfacePoint& place : chain)
  {
    const Point3 image = plane.mirrored(place.position);
    images.push_back(onBoundary(place) ? nearestOnBoundary(other.Mesh, image) : image);
  }
  return other.place(images);
}

bool SeamDrawing::exact(const SurfacePoint& from, const SurfacePoint& to) const
{
  if (from.type != SurfacePointType::Vertex || to.type != SurfacePointType::Vertex)
  {
    return false;
  }
  const Index h = this->Mesh.find(from.id, to.id);
  return h != none && isCrease(this->Mesh, h);
}

Points3 SeamDrawing::draw(const std::vector<SurfacePoint>& chain, int level) const
{
  std::vector<SurfacePoint> points{ chain.front() };
  const auto add = [&points](const SurfacePath& path) {
    points.insert(points.end(), path.points.begin() + 1, path.points.end());
  };
  for (std::size_t begin = 0; begin + 1 < chain.size();)
  {
    std::size_t end = begin;
    SurfacePath path;
    double longest = 0.0;
    while (end + 1 < chain.size() && !this->exact(chain[end], chain[end + 1]))
    {
      const SurfacePoint& from = chain[end];
      const SurfacePoint& to = chain[++end];
      longest = std::max(longest, (to.position - from.position).norm());
      const StraightPath way = commonEdge(this->Mesh, from, to) != none
        ? pathByEdges(this->Graph, from, to)
        : localStraightPath(this->Graph, from, to);
      if (way.path.points.empty())
      {
        return {};
      }
      if (path.points.empty())
      {
        path = way.path;
      }
      else
      {
        append(path, way.path);
      }
    }
    if (end == begin)
    {
      points.push_back(chain[++begin]);
      continue;
    }
    begin = end;
    if (level == 0)
    {
      const StraightPath tight =
        straightPathNear(this->Graph, path, path.points.front(), path.points.back());
      add(tight.status.refused() ? path : tight.path);
      continue;
    }
    const double tolerance = farthest[level] * longest;
    const FittedPath fitted = tolerance > 0.0
      ? fitSpline(this->Graph, this->Locator.points(), path, tolerance)
      : FittedPath();
    if (fitted.segments.empty() || !fitted.status.ok())
    {
      add(path);
      continue;
    }
    for (const SurfacePath& segment : fitted.segments)
    {
      add(segment);
    }
  }
  // What is shorter than the snap distance of an imprint may turn back on itself there, but for
  // what leads from vertex to vertex.
  const double least = minStep * this->Snap.greatest() / placeSnap;
  const auto isVertex = [](const SurfacePoint& p) { return p.type == SurfacePointType::Vertex; };
  std::vector<SurfacePoint> thinned{ points.front() };
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    const bool kept = k + 1 == points.size() || isVertex(points[k]);
    const double step = (points[k].position - thinned.back().position).norm();
    if (kept && step <= least && thinned.size() > 1 && !isVertex(thinned.back()))
    {
      thinned.pop_back();
    }
    if (kept || step > least || commonTriangle(this->Mesh, thinned.back(), points[k + 1]) == none)
    {
      thinned.push_back(points[k]);
    }
  }
  return positionsOf(thinned);
}

std::vector<Indices> failingLines(const ImprintedSurface& imprinted, std::size_t count)
{
  if (imprinted.status.ok())
  {
    return meetingCurves(imprinted);
  }
  if (imprinted.status.curve != none)
  {
    return { { imprinted.status.curve } };
  }
  std::vector<Indices> bad;
  for (Index k = 0; k < static_cast<Index>(count); ++k)
  {
    bad.push_back({ k });
  }
  return bad;
}

bool raiseLevels(const std::vector<Indices>& sets, const Indices& ownerOf, std::vector<int>& levels)
{
  std::set<Index> raised;
  for (const Indices& set : sets)
  {
    Index lowest = none;
    for (Index member : set)
    {
      const Index owner = ownerOf[member];
      if (lowest == none || levels[owner] <= levels[lowest])
      {
        lowest = owner;
      }
    }
    if (levels[lowest] + 1 < SeamDrawing::levels)
    {
      raised.insert(lowest);
    }
  }
  for (Index owner : raised)
  {
    ++levels[owner];
  }
  return !raised.empty();
}
}
