// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathSearch.h"

#include "Paths/StripUnfolding.h"

#include <algorithm>
#include <limits>

namespace flattening
{
namespace
{
/// By how much a straight line may exceed a path of up to a million arcs, each rounded by half a
/// unit.
constexpr double roundingOfPaths = 0x1p20;

/// Corners of the triangles around a point, each once; a vertex is its own only corner.
Indices cornersAround(const TriangleMesh& mesh, const SurfacePoint& point)
{
  if (point.type == SurfacePointType::Vertex)
  {
    return { point.id };
  }
  Indices corners;
  for (const Index t : trianglesAround(mesh, point))
  {
    for (const Index v : mesh.triangle(t))
    {
      if (std::find(corners.begin(), corners.end(), v) == corners.end())
      {
        corners.push_back(v);
      }
    }
  }
  return corners;
}

double apart(const PathGraph& graph, Index vertex, const SurfacePoint& point)
{
  return graph.rounded((graph.mesh().point(vertex) - point.position).norm());
}
}

PathSearch::PathSearch(const PathGraph& graph, const SurfacePoint& source, PathArcs arcs)
  : Graph(graph)
  , Source(source)
  , Used(arcs)
  , States(graph.mesh().vertexCount())
{
  for (const Index v : cornersAround(graph.mesh(), source))
  {
    this->States[v].distance = apart(graph, v, source);
    this->Open.push_back({ 0.0, v });
  }
}

void PathSearch::followArcs(Index vertex, const Point3& target)
{
  const double distance = this->States[vertex].distance;
  for (const PathGraph::Arc& arc : this->Graph.from(vertex))
  {
    if (this->Used == PathArcs::Edges && arc.crossed != none)
    {
      continue;
    }
    State& there = this->States[arc.to];
    const double length = distance + arc.length;
    if (length < there.distance)
    {
      there = { length, vertex, false };
      this->Open.push_back({ length + this->Graph.straight(arc.to, target), arc.to });
      std::push_heap(this->Open.begin(), this->Open.end());
    }
    else if (length == there.distance && there.before != none && vertex < there.before)
    {
      there.before = vertex;
    }
  }
}

Index PathSearch::lastVertex(const SurfacePoint& target)
{
  const Indices goals = cornersAround(this->Graph.mesh(), target);
  eraseIf(this->Open, [this](const Entry& entry) { return this->States[entry.vertex].settled; });
  for (Entry& entry : this->Open)
  {
    entry.bound =
      this->States[entry.vertex].distance + this->Graph.straight(entry.vertex, target.position);
  }
  std::make_heap(this->Open.begin(), this->Open.end());
  Index last = none;
  double best = std::numeric_limits<double>::infinity();
  const auto offer = [&](Index vertex) {
    const State& here = this->States[vertex];
    const double length = here.distance + apart(this->Graph, vertex, target);
    if (here.settled && (length < best || (length == best && vertex < last)))
    {
      best = length;
      last = vertex;
    }
  };
  std::for_each(goals.begin(), goals.end(), offer);
  while (!this->Open.empty() && this->Open.front().bound <= best + roundingOfPaths)
  {
    const Index vertex = this->Open.front().vertex;
    std::pop_heap(this->Open.begin(), this->Open.end());
    this->Open.pop_back();
    State& here = this->States[vertex];
    if (!here.settled)
    {
      here.settled = true;
      this->followArcs(vertex, target.position);
      if (std::find(goals.begin(), goals.end(), vertex) != goals.end())
      {
        offer(vertex);
      }
    }
  }
  return last;
}

Index PathSearch::crossedBetween(Index from, Index to) const
{
  Index crossed = none;
  double shortest = std::numeric_limits<double>::infinity();
  for (const PathGraph::Arc& arc : this->Graph.from(from))
  {
    if (arc.to == to && (this->Used == PathArcs::All || arc.crossed == none) &&
      arc.length < shortest)
    {
      shortest = arc.length;
      crossed = arc.crossed;
    }
  }
  return crossed;
}

GeodesicPath PathSearch::geodesicTo(const SurfacePoint& target)
{
  const TriangleMesh& mesh = this->Graph.mesh();
  const Index last = this->lastVertex(target);
  if (last == none)
  {
    return {};
  }
  GeodesicPath geodesic;
  geodesic.vertices.push_back(this->Source);
  const auto append = [&](const SurfacePoint& vertex, const Indices& crossed) {
    geodesic.append(shortestInStrip(mesh, geodesic.vertices.back(), crossed, vertex));
  };
  Indices chain;
  for (Index v = last; v != none; v = this->States[v].before)
  {
    chain.push_back(v);
  }
  std::reverse(chain.begin(), chain.end());
  Index before = none;
  for (const Index v : chain)
  {
    if (before != none || this->Source.type != SurfacePointType::Vertex)
    {
      const Index crossed = before != none ? this->crossedBetween(before, v) : none;
      append(vertexPoint(mesh, v), crossed != none ? Indices{ crossed } : Indices());
    }
    before = v;
  }
  if (target.type != SurfacePointType::Vertex || geodesic.segments.empty())
  {
    append(target, {});
  }
  return geodesic;
}
}
