// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/GeodesicStraightening.h"

#include "Paths/PathPoints.h"
#include "Paths/StripUnfolding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace flattening
{
namespace
{
/// A direction at a vertex.
struct VertexDirection
{
  Index halfedge = none;  ///< leaves the vertex; its triangle holds the direction
  double angle = 0.0;     ///< from the half-edge, anti-clockwise
  bool alongEdge = false; ///< along the half-edge itself
};

/// Of two sides that are equally sharp but for rounding the right one is taken.
constexpr double equalAngles = 1e-10;

/// The half-edge of the triangle that leaves the vertex.
Index leaving(const TriangleMesh& mesh, Index triangle, Index vertex)
{
  Index h = 3 * triangle;
  while (mesh.from(h) != vertex)
  {
    ++h;
  }
  return h;
}

VertexDirection alongEdge(const TriangleMesh& mesh, Index halfedge, Index vertex)
{
  const Index twin = mesh.twin(halfedge);
  if (mesh.from(halfedge) == vertex)
  {
    return { halfedge, 0.0, true };
  }
  if (twin != none)
  {
    return { twin, 0.0, true };
  }
  // The last edge of a boundary fan has no half-edge that leaves the vertex.
  const Index last = TriangleMesh::next(halfedge);
  return { last, mesh.angle(last), false };
}

/// The direction of a segment along an edge or within one triangle from a vertex towards its other
/// end.
VertexDirection directionWithin(
  const TriangleMesh& mesh, const SurfacePoint& vertex, const SurfacePoint& other)
{
  const Index edge = commonEdge(mesh, vertex, other);
  if (edge != none)
  {
    return alongEdge(mesh, edge, vertex.id);
  }
  const Index h = leaving(mesh, commonTriangle(mesh, other, vertex), vertex.id);
  const Point3& apex = mesh.point(vertex.id);
  return { h, angleBetween(mesh.point(mesh.to(h)) - apex, other.position - apex), false };
}

/// Direction of a segment that leaves a vertex, and of one that arrives there, seen from the
/// vertex.
VertexDirection leavingDirection(const TriangleMesh& mesh, const SurfacePoint& vertex,
  const GeodesicSegment& segment, const SurfacePoint& to)
{
  if (segment.crossed.empty())
  {
    return directionWithin(mesh, vertex, to);
  }
  return { TriangleMesh::previous(segment.crossed.front()), segment.startAngle, false };
}

VertexDirection arrivingDirection(const TriangleMesh& mesh, const SurfacePoint& from,
  const GeodesicSegment& segment, const SurfacePoint& vertex)
{
  if (segment.crossed.empty())
  {
    return directionWithin(mesh, vertex, from);
  }
  return { TriangleMesh::previous(mesh.twin(segment.crossed.back())), segment.endAngle, false };
}

/// The sector from one direction anti-clockwise to the other; `crossed` in this order.
VertexSide sectorBetween(
  const TriangleMesh& mesh, const VertexDirection& from, const VertexDirection& to)
{
  VertexSide side;
  if (from.halfedge == to.halfedge && from.angle <= to.angle)
  {
    side.angle = to.angle - from.angle;
    return side;
  }
  side.angle = mesh.angle(from.halfedge) - from.angle;
  for (Index h = from.halfedge;;)
  {
    const Index next = mesh.counterClockwise(h);
    if (next == none)
    {
      side.angle = std::numeric_limits<double>::infinity();
      side.crossed.clear();
      return side;
    }
    side.crossed.push_back(TriangleMesh::previous(h));
    h = next;
    if (h == to.halfedge)
    {
      break;
    }
    side.angle += mesh.angle(h);
  }
  side.angle += to.angle;
  if (to.alongEdge)
  {
    side.crossed.pop_back();
  }
  return side;
}
}

VertexSide sharperSide(const TriangleMesh& mesh, const SurfacePoint& before,
  const GeodesicSegment& arriving, const SurfacePoint& vertex, const GeodesicSegment& leaving,
  const SurfacePoint& after)
{
  const VertexDirection in = arrivingDirection(mesh, before, arriving, vertex);
  const VertexDirection out = leavingDirection(mesh, vertex, leaving, after);
  VertexSide right = sectorBetween(mesh, in, out);
  VertexSide left = sectorBetween(mesh, out, in);
  if (right.angle <= left.angle + equalAngles)
  {
    return right;
  }
  left.left = true;
  std::reverse(left.crossed.begin(), left.crossed.end());
  for (Index& h : left.crossed)
  {
    h = mesh.twin(h);
  }
  return left;
}

namespace
{
/// How often a path may be led round one vertex without getting shorter by more than rounding.
constexpr int maxIdleTurns = 8;
/// A path is led round a vertex at most so often in all, and so often a vertex of the mesh. One
/// that sweeps over the whole surface once is led round each vertex once.
constexpr std::size_t fewestTurns = 1000;
constexpr std::size_t turnsPerVertex = 10;
/// What rounding may make of the length of two segments; who is shorter than that is shorter.
constexpr double minGain = 1.0 - 1e-14;

/// Straightens in passes. Each leads every run of vertices that are too sharp on one side round
/// them at once, and draws the whole strip between the vertices before and after tight.
class Straightening
{
public:
  Straightening(const TriangleMesh& mesh, GeodesicPath& geodesic)
    : Mesh(mesh)
    , Geodesic(geodesic)
    , Left(fewestTurns + turnsPerVertex * static_cast<std::size_t>(mesh.vertexCount()))
    , Fresh(geodesic.vertices.size(), 1)
  {
  }

  Indices run()
  {
    while (this->pass())
    {
    }
    return std::move(this->Bent);
  }

private:
  /// Whether vertex k has to be led round, and then its sharper side.
  bool isSharp(std::size_t k)
  {
    if (k == 0 || k + 1 >= this->Geodesic.vertices.size() || !this->Fresh[k])
    {
      return false;
    }
    const GeodesicPath& c = this->Geodesic;
    VertexSide side = sharperSide(this->Mesh, c.vertices[k - 1], c.segments[k - 1], c.vertices[k],
      c.segments[k], c.vertices[k + 1]);
    if (!(side.angle < pi - straightAngle))
    {
      return false;
    }
    const auto turns = this->Idle.find(c.vertices[k].id);
    if (this->Left == 0 || (turns != this->Idle.end() && turns->second > maxIdleTurns))
    {
      this->Bent.push_back(c.vertices[k].id);
      return false;
    }
    this->Sides.push_back(std::move(side));
    --this->Left;
    return true;
  }

  /// Whether the path goes back from vertex k along the edge by which it came.
  bool turnsBack(std::size_t k) const
  {
    const GeodesicPath& c = this->Geodesic;
    return k > 0 && k + 1 < c.vertices.size() && c.segments[k - 1].crossed.empty() &&
      c.segments[k].crossed.empty() && samePlace(c.vertices[k - 1], c.vertices[k + 1]);
  }

  bool pass()
  {
    this->Bent.clear();
    GeodesicPath after;
    std::vector<char> fresh{ 0 };
    after.vertices.push_back(this->Geodesic.vertices.front());
    bool changed = false;
    for (std::size_t k = 0; k + 1 < this->Geodesic.vertices.size();)
    {
      this->Sides.clear();
      std::size_t next = k + 1;
      // Where the path turns back along an edge it is on no side of it, and has a run of its own.
      bool back = false;
      while (!back && !(next > k + 1 && this->turnsBack(next)) && this->isSharp(next))
      {
        back = this->turnsBack(next);
        ++next;
      }
      if (next == k + 1)
      {
        after.segments.push_back(std::move(this->Geodesic.segments[k]));
        after.vertices.push_back(this->Geodesic.vertices[next]);
        fresh.push_back(this->isBent(next));
      }
      else
      {
        const GeodesicPath tight = this->ledRound(k, next);
        fresh.back() = 1;
        after.append(tight);
        fresh.resize(after.vertices.size(), 1);
        changed = true;
      }
      k = next;
    }
    if (after.segments.empty())
    {
      after.segments.emplace_back();
      after.vertices.push_back(this->Geodesic.vertices.back());
      fresh.push_back(0);
    }
    this->Geodesic = std::move(after);
    this->Fresh = std::move(fresh);
    return changed;
  }

  bool isBent(std::size_t k) const
  {
    return std::find(this->Bent.begin(), this->Bent.end(), this->Geodesic.vertices[k].id) !=
      this->Bent.end();
  }

  /// The tight way from one vertex to another on the sharper sides of those between.
  GeodesicPath ledRound(std::size_t first, std::size_t last)
  {
    const GeodesicPath& c = this->Geodesic;
    Indices crossed;
    double length = 0.0;
    for (std::size_t k = first; k < last; ++k)
    {
      const Indices& onLeg = c.segments[k].crossed;
      length += c.segments[k].length;
      crossed.insert(crossed.end(), onLeg.begin(), onLeg.end());
      if (k + 1 == last)
      {
        break;
      }
      const VertexSide& side = this->Sides[k - first];
      crossed.insert(crossed.end(), side.crossed.begin(), side.crossed.end());
      if (k + 2 < last && c.segments[k + 1].crossed.empty() &&
        side.left != this->Sides[k - first + 1].left)
      {
        // From one side of the edge between them to the other.
        const Index a = c.vertices[k + 1].id;
        const Index b = c.vertices[k + 2].id;
        crossed.push_back(side.left ? this->Mesh.find(a, b) : this->Mesh.find(b, a));
      }
    }
    const SurfacePoint& start = c.vertices[first];
    const SurfacePoint& end = c.vertices[last];
    crossed = reducedStrip(this->Mesh, start, crossed, end);
    GeodesicPath tight;
    if (crossed.empty() && samePlace(start, end))
    {
      tight.vertices = { start };
    }
    else
    {
      tight = shortestInStrip(this->Mesh, start, crossed, end);
    }
    for (const GeodesicSegment& segment : tight.segments)
    {
      length -= segment.length / minGain;
    }
    for (std::size_t k = first + 1; k < last && !(length > 0.0); ++k)
    {
      ++this->Idle[c.vertices[k].id];
    }
    return tight;
  }

  const TriangleMesh& Mesh;
  GeodesicPath& Geodesic;
  std::size_t Left;              ///< turns
  std::vector<char> Fresh;       ///< vertices whose segments have changed since they were looked at
  std::vector<VertexSide> Sides; ///< of a run of sharp vertices
  std::unordered_map<Index, int> Idle; ///< turns that did not make the path shorter
  Indices Bent;                        ///< sharp vertices that are left
};

/// The half-edge of an edge that lies in the triangle.
Index halfedgeIn(const TriangleMesh& mesh, Index edge, Index triangle)
{
  return edge / 3 == triangle ? edge : mesh.twin(edge);
}

/// Appends the tight way to the next vertex over the half-edges crossed since the last one.
void appendVertex(
  const TriangleMesh& mesh, const SurfacePoint& vertex, Indices& crossed, GeodesicPath& geodesic)
{
  const SurfacePoint start = geodesic.vertices.back();
  const Indices strip = reducedStrip(mesh, start, crossed, vertex);
  crossed.clear();
  if (strip.empty() && samePlace(start, vertex))
  {
    return;
  }
  geodesic.append(shortestInStrip(mesh, start, strip, vertex));
}
}

Indices straighten(const TriangleMesh& mesh, GeodesicPath& geodesic)
{
  return Straightening(mesh, geodesic).run();
}

GeodesicPath geodesicAlong(const TriangleMesh& mesh, const SurfacePath& path)
{
  GeodesicPath geodesic;
  geodesic.vertices.push_back(path.points.front());
  Indices crossed;
  for (std::size_t i = 1; i < path.points.size(); ++i)
  {
    const SurfacePoint& point = path.points[i];
    if (i + 1 == path.points.size() || point.type == SurfacePointType::Vertex)
    {
      appendVertex(mesh, point, crossed, geodesic);
    }
    else if (point.type == SurfacePointType::Edge && path.triangles[i - 1] != path.triangles[i])
    {
      crossed.push_back(halfedgeIn(mesh, point.id, path.triangles[i - 1]));
    }
  }
  if (geodesic.segments.empty())
  {
    geodesic.vertices.push_back(path.points.back());
    geodesic.segments.emplace_back();
  }
  return geodesic;
}

SurfacePath pathAlong(const TriangleMesh& mesh, const GeodesicPath& geodesic)
{
  SurfacePath path;
  path.points.push_back(geodesic.vertices.front());
  const auto push = [&path](const SurfacePoint& point, Index triangle) {
    if (!(point.type == SurfacePointType::Vertex && samePlace(point, path.points.back())))
    {
      path.points.push_back(point);
      path.triangles.push_back(triangle);
    }
  };
  for (std::size_t k = 0; k < geodesic.segments.size(); ++k)
  {
    const Indices& crossed = geodesic.segments[k].crossed;
    const SurfacePoint& from = geodesic.vertices[k];
    const SurfacePoint& to = geodesic.vertices[k + 1];
    const std::vector<double> fractions = crossingFractions(mesh, from, crossed, to);
    for (std::size_t i = 0; i < crossed.size(); ++i)
    {
      push(crossingPoint(mesh, crossed[i], fractions[i]), crossed[i] / 3);
    }
    push(to, crossed.empty() ? commonTriangle(mesh, from, to) : mesh.twin(crossed.back()) / 3);
  }
  if (path.triangles.empty())
  {
    path.points.push_back(geodesic.vertices.back());
    path.triangles.push_back(trianglesAround(mesh, geodesic.vertices.back()).front());
  }
  path.arrived = true;
  return path;
}
}
