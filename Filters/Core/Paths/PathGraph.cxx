// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathGraph.h"

#include "Surface/VertexFan.h"

#include <cmath>

namespace flattening
{
namespace
{
/// Length of the straight way over both triangles of an edge from corner to corner; negative where
/// it would leave them.
double lengthAcross(const TriangleMesh& mesh, Index h)
{
  const Point3& from = mesh.point(mesh.from(h));
  const Point3 along = mesh.point(mesh.to(h)) - from;
  const double length = along.norm();
  const Point3 here = mesh.point(mesh.from(TriangleMesh::previous(h))) - from;
  const Point3 there = mesh.point(mesh.from(TriangleMesh::previous(mesh.twin(h)))) - from;
  const Point2 a(along.dot(here) / length, along.cross(here).norm() / length);
  const Point2 b(along.dot(there) / length, along.cross(there).norm() / length);
  const double height = a.y() + b.y();
  const double at = (a.x() * b.y() + b.x() * a.y()) / height;
  return at > 0.0 && at < length ? std::hypot(b.x() - a.x(), height) : -1.0;
}
}

PathGraph::PathGraph(const TriangleMesh& mesh)
  : Mesh(mesh)
  , NoSnap(mesh, 0.0)
{
  std::vector<double> across(mesh.halfedgeCount(), -1.0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    const Index twin = mesh.twin(h);
    if (twin > h)
    {
      across[h] = lengthAcross(mesh, h);
      across[twin] = across[h];
    }
  }
  this->Begin.reserve(mesh.vertexCount() + 1);
  this->All.reserve(4 * static_cast<std::size_t>(mesh.halfedgeCount()));
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    this->Begin.push_back(this->All.size());
    for (const Index h : VertexFan(mesh, v))
    {
      this->All.push_back({ mesh.to(h), none, mesh.length(h) });
      const Index opposite = TriangleMesh::next(h);
      if (across[opposite] > 0.0)
      {
        const Index beyond = TriangleMesh::previous(mesh.twin(opposite));
        this->All.push_back({ mesh.from(beyond), opposite, across[opposite] });
      }
      const Index last = TriangleMesh::previous(h);
      if (mesh.twin(last) == none)
      {
        this->All.push_back({ mesh.from(last), none, mesh.length(last) });
      }
    }
  }
  this->Begin.push_back(this->All.size());
}
}
