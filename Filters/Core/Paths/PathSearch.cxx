// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathSearch.h"

#include "Paths/StripUnfolding.h"

#include <algorithm>
#include <functional>
#include <queue>

namespace flattening
{
namespace
{
struct Entry
{
  double bound = 0.0; ///< of the whole way
  Index vertex = none;
  bool operator>(const Entry& other) const
  {
    return this->bound != other.bound ? this->bound > other.bound : this->vertex > other.vertex;
  }
};

/// Corners of the triangles around a point, each once; a vertex is its own only corner.
Indices cornersAround(const TriangleMesh& mesh, const SurfacePoint& point)
{
  if (point.carrier == Carrier::Vertex)
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

double apart(const TriangleMesh& mesh, Index vertex, const SurfacePoint& point)
{
  return (mesh.point(vertex) - point.position).norm();
}
}

PathSearch::PathSearch(
  const PathGraph& graph, const SurfacePoint& source, const SurfacePoint& target, PathWays ways)
  : Graph(graph)
  , Source(source)
{
  this->run(&target, std::numeric_limits<double>::infinity(), ways);
}

PathSearch::PathSearch(const PathGraph& graph, const SurfacePoint& source, double reach)
  : Graph(graph)
  , Source(source)
{
  this->run(nullptr, reach, PathWays::All);
}

void PathSearch::run(const SurfacePoint* target, double reach, PathWays ways)
{
  const TriangleMesh& mesh = this->Graph.mesh();
  this->Found.assign(mesh.vertexCount(), State());
  const Indices goals = target ? cornersAround(mesh, *target) : Indices();
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto push = [&](Index v) {
    const double ahead = target ? apart(mesh, v, *target) : 0.0;
    queue.push({ this->Found[v].distance + ahead, v });
  };
  for (const Index v : cornersAround(mesh, this->Source))
  {
    this->Found[v].distance = apart(mesh, v, this->Source);
    push(v);
  }
  double best = reach;
  while (!queue.empty() && queue.top().bound <= best)
  {
    const Index v = queue.top().vertex;
    queue.pop();
    State& here = this->Found[v];
    if (here.settled)
    {
      continue;
    }
    here.settled = true;
    if (std::find(goals.begin(), goals.end(), v) != goals.end())
    {
      best = std::min(best, here.distance + apart(mesh, v, *target));
    }
    for (const PathGraph::Way& way : this->Graph.from(v))
    {
      const double distance = here.distance + way.length;
      State& there = this->Found[way.vertex];
      if (distance < there.distance && (ways == PathWays::All || way.crossed == none))
      {
        there.distance = distance;
        there.way = &way;
        there.before = v;
        push(way.vertex);
      }
    }
  }
}

PathCourse PathSearch::courseTo(const SurfacePoint& target) const
{
  const TriangleMesh& mesh = this->Graph.mesh();
  Index last = none;
  double best = std::numeric_limits<double>::infinity();
  for (const Index v : cornersAround(mesh, target))
  {
    const double length = this->Found[v].distance + apart(mesh, v, target);
    if (length < best)
    {
      best = length;
      last = v;
    }
  }
  if (last == none)
  {
    return {};
  }
  Indices chain;
  for (Index v = last; v != none; v = this->Found[v].before)
  {
    chain.push_back(v);
  }
  std::reverse(chain.begin(), chain.end());
  PathCourse course;
  course.knots.push_back(this->Source);
  const auto append = [&](const SurfacePoint& knot, const Indices& crossed) {
    PathCourse tight = shortestInStrip(mesh, course.knots.back(), crossed, knot);
    for (std::size_t i = 0; i < tight.legs.size(); ++i)
    {
      course.legs.push_back(std::move(tight.legs[i]));
      course.knots.push_back(tight.knots[i + 1]);
    }
  };
  for (const Index v : chain)
  {
    const PathGraph::Way* way = this->Found[v].way;
    if (way || this->Source.carrier != Carrier::Vertex)
    {
      append(
        vertexPoint(mesh, v), way && way->crossed != none ? Indices{ way->crossed } : Indices());
    }
  }
  if (target.carrier != Carrier::Vertex || course.legs.empty())
  {
    append(target, {});
  }
  return course;
}
}
