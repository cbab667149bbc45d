// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathGraph.h"

#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// What a mean way comes to: digits enough, and so few that rounding of the mesh does not reach
/// them.
constexpr double meanWay = 0x1p36;
/// Digits of a coordinate that order vertices: finer than most edges of a million.
constexpr int orderBits = 21;

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

/// By half-edge; negative where there is no such way.
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

/// The digits of a number with two zeros before each.
std::uint64_t spread(std::uint64_t digits)
{
  digits = (digits | digits << 32U) & 0x1f00000000ffffU;
  digits = (digits | digits << 16U) & 0x1f0000ff0000ffU;
  digits = (digits | digits << 8U) & 0x100f00f00f00f00fU;
  digits = (digits | digits << 4U) & 0x10c30c30c30c30c3U;
  return (digits | digits << 2U) & 0x1249249249249249U;
}

/// The vertices along a curve that fills space (G. M. Morton, 1966).
Indices orderInSpace(const Points3& points)
{
  Point3 low = Point3::Zero();
  Point3 high = Point3::Zero();
  if (!points.empty())
  {
    low = high = points.front();
  }
  for (const Point3& point : points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double size = (high - low).maxCoeff();
  const double scale = size > 0.0 ? ((1 << orderBits) - 1) / size : 0.0;
  std::vector<std::pair<std::uint64_t, Index>> places;
  places.reserve(points.size());
  for (const Point3& point : points)
  {
    std::uint64_t place = 0;
    for (int i = 0; i < 3; ++i)
    {
      place |= spread(static_cast<std::uint64_t>((point[i] - low[i]) * scale))
        << static_cast<unsigned>(i);
    }
    places.emplace_back(place, static_cast<Index>(places.size()));
  }
  std::sort(places.begin(), places.end());
  Indices order;
  order.reserve(places.size());
  for (const auto& [place, vertex] : places)
  {
    order.push_back(vertex);
  }
  return order;
}
}

PathGraph::PathGraph(const TriangleMesh& mesh)
  : Mesh(mesh)
  , NoSnap(mesh, 0.0)
  , Vertices(orderInSpace(mesh.points()))
  , Nodes(mesh.vertexCount())
{
  const std::vector<double> across = lengthsAcross(mesh);
  double sum = 0.0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    sum += 2.0 * mesh.length(h) + (across[h] > 0.0 ? across[h] : 0.0);
  }
  // The ways of each edge, both ways, along it and across.
  const double mean = sum / (4.0 * std::max<Index>(mesh.halfedgeCount(), 1));
  this->Scale = sum > 0.0 ? std::min(sumOfAll / sum, meanWay / mean) : 1.0;
  this->Positions.reserve(this->Vertices.size());
  for (const Index v : this->Vertices)
  {
    this->Nodes[v] = static_cast<Index>(this->Positions.size());
    this->Positions.push_back(mesh.point(v));
  }
  this->Begin.reserve(this->Vertices.size() + 1);
  this->All.reserve(4 * static_cast<std::size_t>(mesh.halfedgeCount()));
  for (const Index v : this->Vertices)
  {
    this->Begin.push_back(this->All.size());
    const auto add = [this](Index to, Index crossed, double length) {
      this->All.push_back({ this->Nodes[to], crossed, this->rounded(length) });
    };
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

void PathGraph::setLandmarks(std::vector<LandmarkDistances> distances)
{
  this->Landmarks = std::move(distances);
}

WayLength PathGraph::rounded(double length) const
{
  return std::max<WayLength>(std::llround(length * this->Scale), 1);
}

}
