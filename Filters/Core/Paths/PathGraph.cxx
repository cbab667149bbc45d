// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathGraph.h"

#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Units of a mean arc: rounding errors of coordinates are below one unit.
constexpr double unitsOfMeanArc = 0x1p36;
/// Units of all arcs together: sums of doubles below 2^53 are exact.
constexpr double unitsOfAllArcs = 0x1p52;

/// Length of the straight arc across an edge from corner to corner of its two triangles; negative
/// where it would leave them.
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

/// By half-edge; negative where there is no such arc.
std::vector<double> lengthsAcross(const TriangleMesh& mesh)
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
  return across;
}

}

PathGraph::PathGraph(const TriangleMesh& mesh)
  : Mesh(mesh)
  , NoSnap(mesh, 0.0)
{
  const std::vector<double> across = lengthsAcross(mesh);
  double sum = 0.0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    sum += 2.0 * mesh.length(h) + std::max(across[h], 0.0);
  }
  // Both directions of each edge, along it and across.
  const double mean = sum / (4.0 * std::max<Index>(mesh.halfedgeCount(), 1));
  this->Scale = sum > 0.0 ? std::min(unitsOfAllArcs / sum, unitsOfMeanArc / mean) : 1.0;
  this->Begin.reserve(static_cast<std::size_t>(mesh.vertexCount()) + 1);
  this->All.reserve(4 * static_cast<std::size_t>(mesh.halfedgeCount()));
  const auto add = [this](Index to, Index crossed, double length) {
    this->All.push_back({ to, crossed, this->rounded(length) });
  };
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    this->Begin.push_back(this->All.size());
    for (const Index h : VertexFan(mesh, v))
    {
      add(mesh.to(h), none, mesh.length(h));
      const Index opposite = TriangleMesh::next(h);
      if (across[opposite] > 0.0)
      {
        add(mesh.from(TriangleMesh::previous(mesh.twin(opposite))), opposite, across[opposite]);
      }
      const Index last = TriangleMesh::previous(h);
      if (mesh.twin(last) == none)
      {
        add(mesh.from(last), none, mesh.length(last));
      }
    }
  }
  this->Begin.push_back(this->All.size());
}

double PathGraph::rounded(double length) const
{
  return std::max(std::nearbyint(length * this->Scale), 1.0);
}
}
