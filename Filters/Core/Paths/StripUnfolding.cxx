// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/StripUnfolding.h"

#include "Surface/TriangleFrame.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Of the angle by which a path may miss a vertex and still go through it.
constexpr double touchAngle = 1e-11;

double cross(const Complex& u, const Complex& v)
{
  return u.real() * v.imag() - u.imag() * v.real();
}

double dot(const Complex& u, const Complex& v)
{
  return u.real() * v.real() + u.imag() * v.imag();
}

/// A point of the triangle of a half-edge, seen from the half-edge's start along it.
Complex placeBeside(const TriangleMesh& mesh, Index h, const Point3& point)
{
  const Point3& from = mesh.point(mesh.from(h));
  const Point3 along = mesh.point(mesh.to(h)) - from;
  const Point3 way = point - from;
  const double length = along.norm();
  return { along.dot(way) / length, along.cross(way).norm() / length };
}

/// A strip of triangles in the plane, the start at its origin. Directions are handed on from
/// triangle to triangle for themselves: taken from differences of places far from the origin they
/// would lose the digits of short edges.
class UnfoldedStrip
{
public:
  struct Portal
  {
    Index halfedge;
    Complex direction; ///< of the half-edge, of length 1
    double length;     ///< of the half-edge
    Complex right;     ///< its start, as one who leaves by it sees it
    Complex left;
  };

  UnfoldedStrip(const TriangleMesh& mesh, const SurfacePoint& start, const Indices& crossed,
    const SurfacePoint& end)
    : Mesh(mesh)
  {
    this->Portals.reserve(crossed.size());
    const Complex first = placeBeside(mesh, crossed[0], start.position);
    const double length = mesh.length(crossed[0]);
    this->Portals.push_back({ crossed[0], 1.0, length, -first, length - first });
    for (std::size_t i = 1; i < crossed.size(); ++i)
    {
      this->unfold(crossed[i]);
    }
    const Portal& last = this->Portals.back();
    this->EndPlace =
      last.left - last.direction * placeBeside(mesh, mesh.twin(last.halfedge), end.position);
  }

  std::size_t size() const { return this->Portals.size(); }
  const Portal& operator[](std::size_t i) const { return this->Portals[i]; }
  Complex end() const { return this->EndPlace; }

  /// The angle at a corner from the half-edge of its triangle to a direction; `behind` where the
  /// triangle is the one that the portal leads to.
  double angleAt(std::size_t portal, const Point3& corner, Complex direction, bool behind) const
  {
    const Portal& p = this->Portals[portal];
    const Index h = behind ? this->Mesh.twin(p.halfedge) : p.halfedge;
    const Complex local = (behind ? -1.0 : 1.0) * std::conj(p.direction) * direction;
    const Complex turned = std::conj(-placeBeside(this->Mesh, h, corner)) * local;
    return std::max(std::arg(turned), 0.0);
  }

private:
  void unfold(Index next)
  {
    const Portal before = this->Portals.back();
    const Index entry = this->Mesh.twin(before.halfedge);
    const Point3& apex = this->Mesh.point(this->Mesh.from(TriangleMesh::previous(entry)));
    const Point3& from = this->Mesh.point(this->Mesh.from(entry));
    const Point3& to = this->Mesh.point(this->Mesh.to(entry));
    const Point3 edge = to - from;
    const Point3 side = apex - from;
    const Complex local(edge.dot(side) / before.length, edge.cross(side).norm() / before.length);
    const Complex along = -before.direction;
    const Complex place = before.left + along * local;
    const bool keepsRight = next == TriangleMesh::next(entry);
    const double length = (keepsRight ? Point3(apex - to) : side).norm();
    Complex direction = along * (keepsRight ? local - before.length : -local);
    direction /= std::sqrt(std::norm(direction));
    this->Portals.push_back({ next, direction, length, keepsRight ? before.right : place,
      keepsRight ? place : before.left });
  }

  const TriangleMesh& Mesh;
  std::vector<Portal> Portals;
  Complex EndPlace;
};

/// A corner of the strip, with the portals that end in it.
struct StripCorner
{
  Complex place;
  Index vertex = none;
  Index first = none;
  Index last = none;
  Index before = none; ///< on the shortest path to it
};

/// The funnel: two concave chains of corners from the apex to both ends of the last portal.
class Funnel
{
public:
  explicit Funnel(std::size_t portals)
    : Chain(2 * portals + 5)
    , Left(portals + 2)
    , Apex(Left)
    , Right(Left)
  {
    this->Corners.reserve(portals + 3);
    this->Corners.push_back({ 0.0 });
    this->Chain[this->Apex] = 0;
  }

  std::vector<StripCorner> Corners;

  /// Adds the next corner of one side; what holds of the left side holds mirrored of the right.
  Index add(const StripCorner& corner, bool onLeft)
  {
    std::size_t& end = onLeft ? this->Left : this->Right;
    const std::size_t opposite = onLeft ? this->Right : this->Left;
    const int outwards = onLeft ? -1 : 1;
    const auto side = [&](std::size_t a, std::size_t b) {
      return outwards * this->side(a, b, corner.place);
    };
    while (end != this->Apex && side(end - outwards, end) >= 0.0)
    {
      end -= outwards;
    }
    if (end == this->Apex)
    {
      while (this->Apex != opposite && side(this->Apex, this->Apex - outwards) > 0.0)
      {
        this->Apex -= outwards;
      }
      end = this->Apex;
    }
    this->Corners.push_back(corner);
    this->Corners.back().before = this->Chain[end];
    end += outwards;
    this->Chain[end] = static_cast<Index>(this->Corners.size()) - 1;
    return this->Chain[end];
  }

private:
  /// Positive where p lies on the left of the line through two places of the chain.
  double side(std::size_t a, std::size_t b, Complex p) const
  {
    const Complex origin = this->Corners[this->Chain[a]].place;
    return cross(this->Corners[this->Chain[b]].place - origin, p - origin);
  }

  Indices Chain;
  std::size_t Left;
  std::size_t Apex;
  std::size_t Right;
};

/// The corners that the tight string from start to end goes through, both included.
std::vector<StripCorner> tightString(const TriangleMesh& mesh, const UnfoldedStrip& strip)
{
  const auto count = static_cast<Index>(strip.size());
  Funnel funnel(strip.size());
  Index left = none;
  Index right = none;
  for (Index i = 0; i < count; ++i)
  {
    const Index h = strip[i].halfedge;
    if (i == 0 || mesh.to(h) != funnel.Corners[left].vertex)
    {
      left = funnel.add({ strip[i].left, mesh.to(h), i, i, none }, true);
    }
    if (i == 0 || mesh.from(h) != funnel.Corners[right].vertex)
    {
      right = funnel.add({ strip[i].right, mesh.from(h), i, i, none }, false);
    }
    funnel.Corners[left].last = i;
    funnel.Corners[right].last = i;
  }
  funnel.add({ strip.end(), none, count, count, none }, true);
  std::vector<StripCorner> string;
  for (auto c = static_cast<Index>(funnel.Corners.size()) - 1; c != none;
       c = funnel.Corners[c].before)
  {
    string.push_back(funnel.Corners[c]);
  }
  std::reverse(string.begin(), string.end());
  return string;
}

/// Adds the corners that the way to b passes so closely that it goes through them.
void pushTouched(const TriangleMesh& mesh, const UnfoldedStrip& strip, const StripCorner& b,
  std::vector<StripCorner>& string)
{
  StripCorner a = string.back();
  Complex way = b.place - a.place;
  double square = std::norm(way);
  for (Index i = a.last + 1; i < b.first; ++i)
  {
    for (const bool left : { true, false })
    {
      const Complex place = left ? strip[i].left : strip[i].right;
      const Complex there = place - a.place;
      const double done = dot(way, there);
      if (!(std::abs(cross(way, there)) <= touchAngle * std::min(done, square - done)))
      {
        continue;
      }
      const auto endOf = [&](Index portal) {
        const Index h = strip[portal].halfedge;
        return left ? mesh.to(h) : mesh.from(h);
      };
      a = { place, endOf(i), i, i, none };
      while (a.last + 1 < static_cast<Index>(strip.size()) && endOf(a.last + 1) == a.vertex)
      {
        ++a.last;
      }
      i = a.last;
      way = b.place - a.place;
      square = std::norm(way);
      string.push_back(a);
      break;
    }
  }
}
}

GeodesicPath shortestInStrip(const TriangleMesh& mesh, const SurfacePoint& start,
  const Indices& crossed, const SurfacePoint& end)
{
  GeodesicPath geodesic;
  geodesic.vertices.push_back(start);
  if (crossed.empty())
  {
    geodesic.vertices.push_back(end);
    geodesic.segments.push_back({ {}, (end.position - start.position).norm() });
    return geodesic;
  }
  const UnfoldedStrip strip(mesh, start, crossed, end);
  const std::vector<StripCorner> tight = tightString(mesh, strip);
  std::vector<StripCorner> string{ tight.front() };
  for (std::size_t k = 1; k < tight.size(); ++k)
  {
    pushTouched(mesh, strip, tight[k], string);
    string.push_back(tight[k]);
  }
  for (std::size_t k = 1; k < string.size(); ++k)
  {
    const StripCorner& a = string[k - 1];
    const StripCorner& b = string[k];
    const SurfacePoint vertex = b.vertex == none ? end : vertexPoint(mesh, b.vertex);
    const Complex way = b.place - a.place;
    GeodesicSegment segment;
    segment.length = std::abs(way);
    if (a.last + 1 < b.first)
    {
      segment.crossed.assign(crossed.begin() + a.last + 1, crossed.begin() + b.first);
      segment.startAngle = strip.angleAt(a.last + 1, geodesic.vertices.back().position, way, false);
      segment.endAngle = strip.angleAt(b.first - 1, vertex.position, -way, true);
    }
    geodesic.segments.push_back(std::move(segment));
    geodesic.vertices.push_back(vertex);
  }
  return geodesic;
}

Indices reducedStrip(const TriangleMesh& mesh, const SurfacePoint& start, const Indices& crossed,
  const SurfacePoint& end)
{
  Indices strip;
  for (const Index h : crossed)
  {
    if (!strip.empty() && strip.back() == mesh.twin(h))
    {
      strip.pop_back();
    }
    else
    {
      strip.push_back(h);
    }
  }
  const auto first =
    std::find_if(strip.begin(), strip.end(), [&](Index h) { return !edgeHolds(mesh, h, start); });
  strip.erase(strip.begin(), first);
  while (!strip.empty() && edgeHolds(mesh, strip.back(), end))
  {
    strip.pop_back();
  }
  return strip;
}

std::vector<double> crossingFractions(const TriangleMesh& mesh, const SurfacePoint& start,
  const Indices& crossed, const SurfacePoint& end)
{
  std::vector<double> fractions;
  if (crossed.empty())
  {
    return fractions;
  }
  const UnfoldedStrip strip(mesh, start, crossed, end);
  for (std::size_t i = 0; i < strip.size(); ++i)
  {
    const double right = std::max(-cross(strip.end(), strip[i].right), 0.0);
    const double left = std::max(cross(strip.end(), strip[i].left), 0.0);
    const double both = right + left;
    fractions.push_back(both > 0.0 ? right / both : 0.5);
  }
  return fractions;
}
}
