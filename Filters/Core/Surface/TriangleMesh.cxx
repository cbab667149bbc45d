// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/TriangleMesh.h"

#include "Base/Types.h"
#include "Surface/HalfedgeKey.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
TriangleMesh::TriangleMesh(Points3 points, Triangles triangles)
{
  Indices twins = pairSides(sortedSides(triangles, points.size()));
  *this = TriangleMesh(std::move(points), std::move(triangles), std::move(twins));
}

TriangleMesh::TriangleMesh(Points3 points, Triangles triangles, Indices twins)
  : Points(std::move(points))
  , Cells(std::move(triangles))
  , Twins(std::move(twins))
  , Outgoing(Points.size(), none)
{
  Index h = 0;
  for (const Triangle& t : this->Cells)
  {
    for (Index v : t)
    {
      Index& outgoing = this->Outgoing[v];
      if (outgoing == none || this->Twins[h] == none)
      {
        outgoing = h;
      }
      ++h;
    }
  }
}

Index TriangleMesh::find(Index fromVertex, Index toVertex) const
{
  // Around both ends by turns, so that only the fan of the smaller one is walked.
  const Index first[2] = { this->Outgoing[fromVertex], this->Outgoing[toVertex] };
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
  const Index h = this->Outgoing[vertex];
  return h != none && this->Twins[h] == none;
}

bool TriangleMesh::identical(const TriangleMesh& other) const
{
  return sameBits(this->Points, other.Points) && this->Cells == other.Cells &&
    this->Twins == other.Twins;
}

double TriangleMesh::angle(Index h) const
{
  const Point3& apex = this->point(this->from(h));
  return angleBetween(this->point(this->to(h)) - apex, this->point(this->from(previous(h))) - apex);
}

double TriangleMesh::area(Index t) const
{
  const Triangle& c = this->Cells[t];
  return 0.5 * areaVector(this->point(c[0]), this->point(c[1]), this->point(c[2])).norm();
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
  const auto begin = this->Twins.begin();
  const auto end = this->Twins.end();
  for (auto at = std::find(begin, end, none); at != end; at = std::find(at + 1, end, none))
  {
    if (seen[at - begin])
    {
      continue;
    }
    Indices loop;
    double length = 0.0;
    for (auto h = static_cast<Index>(at - begin); !seen[h]; h = this->Outgoing[this->to(h)])
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
    const Point3 normal =
      areaVector(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2])).normalized();
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
}
