// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/TriangleMesh.h"

#include "Base/Types.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
TriangleMesh::TriangleMesh(Points3 points, Triangles triangles)
{
  Indices twins = pairSides(sortedSides(triangles, points.size()));
  *this = TriangleMesh(std::move(points), std::move(triangles), std::move(twins));
}

TriangleMesh::TriangleMesh(Points3 points, Triangles triangles, Indices twins)
{
  Indices outgoing(points.size(), none);
  Index h = 0;
  for (const Triangle& t : triangles)
  {
    for (Index v : t)
    {
      if (outgoing[v] == none || twins[h] == none)
      {
        outgoing[v] = h;
      }
      ++h;
    }
  }
  this->Shared = std::make_shared<const Arrays>(
    Arrays{ std::move(points), std::move(triangles), std::move(twins), std::move(outgoing) });
}

Index TriangleMesh::find(Index fromVertex, Index toVertex) const
{
  // Around both ends by turns, so that only the fan of the smaller one is walked.
  const Index first[2] = { this->outgoing(fromVertex), this->outgoing(toVertex) };
  Index h = first[0];
  Index g = first[1];
  while (h != none && g != none)
  {
    if (this->to(h) == toVertex)
    {
      return h;
    }
    if (this->from(previous(g)) == fromVertex)
    {
      return previous(g);
    }
    h = this->counterClockwise(h);
    g = this->counterClockwise(g);
    if (h == first[0] || g == first[1])
    {
      break;
    }
  }
  return none;
}

bool TriangleMesh::onBoundary(Index vertex) const
{
  const Index h = this->outgoing(vertex);
  return h != none && this->twin(h) == none;
}

bool TriangleMesh::identical(const TriangleMesh& other) const
{
  return this->Shared == other.Shared ||
    (sameBits(this->points(), other.points()) && this->triangles() == other.triangles() &&
      this->twins() == other.twins());
}

double TriangleMesh::angle(Index h) const
{
  const Point3& apex = this->point(this->from(h));
  return angleBetween(this->point(this->to(h)) - apex, this->point(this->from(previous(h))) - apex);
}

Point3 TriangleMesh::centroid(Index t) const
{
  const auto& [a, b, c] = this->triangle(t);
  return (this->point(a) + this->point(b) + this->point(c)) / 3.0;
}

double TriangleMesh::area(Index t) const
{
  return 0.5 * areaVector(this->points(), this->triangle(t)).norm();
}

double TriangleMesh::area() const
{
  double sum = 0.0;
  for (Index t = 0; t < this->triangleCount(); ++t)
  {
    sum += this->area(t);
  }
  return sum;
}

std::vector<Indices> TriangleMesh::boundaryLoops() const
{
  std::vector<Indices> loops;
  std::vector<double> lengths;
  std::vector<char> seen(this->halfedgeCount(), 0);
  const auto begin = this->twins().begin();
  const auto end = this->twins().end();
  for (auto at = std::find(begin, end, none); at != end; at = std::find(at + 1, end, none))
  {
    if (seen[at - begin])
    {
      continue;
    }
    Indices loop;
    double length = 0.0;
    for (auto h = static_cast<Index>(at - begin); !seen[h]; h = this->outgoing(this->to(h)))
    {
      seen[h] = 1;
      loop.push_back(h);
      length += this->length(h);
    }
    loops.push_back(std::move(loop));
    lengths.push_back(length);
  }
  const auto longest = std::max_element(lengths.begin(), lengths.end()) - lengths.begin();
  if (!loops.empty())
  {
    std::rotate(loops.begin(), loops.begin() + longest, loops.begin() + longest + 1);
  }
  return loops;
}

Index eulerCharacteristic(const TriangleMesh& mesh)
{
  Index vertices = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    vertices += mesh.outgoing(v) != none ? 1 : 0;
  }
  Index boundary = 0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    boundary += mesh.twin(h) == none ? 1 : 0;
  }
  const Index edges = (mesh.halfedgeCount() + boundary) / 2;
  return vertices - edges + mesh.triangleCount();
}

Index connectedParts(
  const TriangleMesh& mesh, const std::vector<char>& barred, Indices& partOfTriangle)
{
  partOfTriangle.assign(mesh.triangleCount(), none);
  Index count = 0;
  Indices reached(mesh.triangleCount());
  Index known = 0;
  Index done = 0;
  const auto reach = [&](Index t) {
    partOfTriangle[t] = count;
    reached[known++] = t;
  };
  const bool whole = barred.empty();
  for (Index seed = 0; seed < mesh.triangleCount(); ++seed)
  {
    if (partOfTriangle[seed] != none)
    {
      continue;
    }
    for (reach(seed); done < known; ++done)
    {
      for (Index h = 3 * reached[done]; h < 3 * reached[done] + 3; ++h)
      {
        const Index twin = mesh.twin(h);
        if (twin != none && (whole || !barred[h]) && partOfTriangle[twin / 3] == none)
        {
          reach(twin / 3);
        }
      }
    }
    ++count;
  }
  return count;
}

Points3 vertexNormals(const TriangleMesh& mesh)
{
  Points3 normals(mesh.vertexCount(), Point3::Zero());
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangle(t);
    const Point3 normal = areaVector(mesh.points(), c).normalized();
    for (int k = 0; k < 3; ++k)
    {
      normals[c[k]] += mesh.angle(3 * t + k) * normal;
    }
  }
  for (Point3& normal : normals)
  {
    normal.normalize();
  }
  return normals;
}

std::vector<HalfedgeKey> sortedSides(const Triangles& triangles, std::size_t vertexCount)
{
  const auto side = [&triangles](std::size_t h) -> HalfedgeKey {
    const Index a = triangles[h / 3][h % 3];
    const Index b = triangles[h / 3][(h + 1) % 3];
    return { std::min(a, b), std::max(a, b), static_cast<Index>(h) };
  };
  const std::size_t count = 3 * triangles.size();
  Indices begin(vertexCount + 1, 0);
  for (std::size_t h = 0; h < count; ++h)
  {
    ++begin[side(h).low + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  Indices place(begin.begin(), begin.end() - 1);
  std::vector<HalfedgeKey> sides(count);
  for (std::size_t h = 0; h < count; ++h)
  {
    const HalfedgeKey s = side(h);
    sides[place[s.low]++] = s;
  }
  for (std::size_t v = 0; v < vertexCount; ++v)
  {
    std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1],
      [](const HalfedgeKey& a, const HalfedgeKey& b) {
        return a.high != b.high ? a.high < b.high : a.halfedge < b.halfedge;
      });
  }
  return sides;
}

Indices pairSides(const std::vector<HalfedgeKey>& sides)
{
  Indices partner(sides.size(), none);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    if (sides[i].low == sides[i + 1].low && sides[i].high == sides[i + 1].high)
    {
      partner[sides[i].halfedge] = sides[i + 1].halfedge;
      partner[sides[i + 1].halfedge] = sides[i].halfedge;
    }
  }
  return partner;
}

std::vector<Indices> crowdedEdges(const std::vector<HalfedgeKey>& sides, std::size_t least)
{
  std::vector<Indices> crowded;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end)
  {
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
    {
      ++end;
    }
    if (end - i >= least)
    {
      crowded.emplace_back();
      for (std::size_t k = i; k < end; ++k)
      {
        crowded.back().push_back(sides[k].halfedge);
      }
    }
  }
  return crowded;
}

Indices pairOrientedSides(const Triangles& triangles, std::size_t vertexCount)
{
  // Sides that leave or reach a vertex from one with a greater id, as a list a vertex.
  constexpr int longestList = 64;
  const Index count = 3 * static_cast<Index>(triangles.size());
  Indices first(vertexCount, none);
  Indices following(count, none);
  Indices high(count, none);
  Indices partner(count, none);
  for (Index h = 0; h < count; ++h)
  {
    const Triangle& corner = triangles[h / 3];
    const Index from = corner[h % 3];
    const Index to = corner[(h + 1) % 3];
    const Index low = std::min(from, to);
    high[h] = std::max(from, to);
    Index other = first[low];
    for (int steps = 0; other != none && high[other] != high[h]; other = following[other])
    {
      if (++steps > longestList)
      {
        return {};
      }
    }
    if (other == none)
    {
      following[h] = first[low];
      first[low] = h;
      continue;
    }
    const Triangle& opposite = triangles[other / 3];
    if (partner[other] != none || opposite[other % 3] == from ||
      opposite[(other + 2) % 3] == corner[(h + 2) % 3])
    {
      return {};
    }
    partner[h] = other;
    partner[other] = h;
  }
  return partner;
}
}
