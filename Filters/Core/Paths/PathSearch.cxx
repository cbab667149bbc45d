// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathSearch.h"

#include "Paths/StripUnfolding.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace flattening
{
namespace
{
/// By how much the distance through the air may seem to be longer than a way of ever so many parts,
/// each rounded: a hundred thousandth of a mean edge where there are a million.
constexpr WayLength roundingOfWays = WayLength(1) << 20U;

/// Corners of the triangles around a point as nodes, each once; a vertex is its own only corner.
Indices nodesAround(const PathGraph& graph, const SurfacePoint& point)
{
  if (point.carrier == Carrier::Vertex)
  {
    return { graph.node(point.id) };
  }
  Indices nodes;
  for (const Index t : trianglesAround(graph.mesh(), point))
  {
    for (const Index v : graph.mesh().triangle(t))
    {
      const Index node = graph.node(v);
      if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
      {
        nodes.push_back(node);
      }
    }
  }
  return nodes;
}

WayLength difference(WayLength a, WayLength b)
{
  return a > b ? a - b : b - a;
}

WayLength apart(const PathGraph& graph, Index node, const SurfacePoint& point)
{
  return graph.rounded((graph.position(node) - point.position).norm());
}
}

PathSearch::PathSearch(const PathGraph& graph, const SurfacePoint& source, PathWays ways)
  : Graph(graph)
  , Source(source)
  , Taken(ways)
  , Pages(graph.nodeCount() / std::tuple_size<Page>::value + 1)
{
  for (const Index node : nodesAround(graph, source))
  {
    this->state(node).distance = apart(graph, node, source);
    this->Open.push_back({ 0, node });
  }
}

/// No way from a node to the target is shorter.
WayLength PathSearch::ahead(Index node, const Point3& target) const
{
  WayLength least = this->Graph.straight(node, target);
  for (std::size_t k = 0; k < this->MarkCount; ++k)
  {
    const Mark& mark = this->Marks[k];
    least =
      std::max(least, difference((*this->Graph.landmarks(node))[mark.landmark], mark.toTarget));
  }
  return least;
}

void PathSearch::chooseMarks(const SurfacePoint& target, const Indices& goals)
{
  this->MarkCount = 0;
  const Index start = nodesAround(this->Graph, this->Source).front();
  const LandmarkDistances* const fromStart = this->Graph.landmarks(start);
  if (!fromStart)
  {
    return;
  }
  LandmarkDistances toTarget;
  toTarget.fill(std::numeric_limits<WayLength>::max());
  for (const Index node : goals)
  {
    const WayLength last = apart(this->Graph, node, target);
    for (std::size_t k = 0; k < landmarkCount; ++k)
    {
      toTarget[k] = std::min(toTarget[k], (*this->Graph.landmarks(node))[k] + last);
    }
  }
  std::array<std::size_t, landmarkCount> order{};
  std::iota(order.begin(), order.end(), 0);
  const auto seemsLonger = [&](std::size_t a, std::size_t b) {
    return difference((*fromStart)[a], toTarget[a]) > difference((*fromStart)[b], toTarget[b]);
  };
  this->MarkCount = this->Marks.size();
  std::partial_sort(order.begin(), order.begin() + this->Marks.size(), order.end(), seemsLonger);
  for (std::size_t k = 0; k < this->MarkCount; ++k)
  {
    this->Marks[k] = { order[k], toTarget[order[k]] };
  }
}

void PathSearch::aimAt(const SurfacePoint& target, const Indices& goals)
{
  this->chooseMarks(target, goals);
  std::vector<Entry> open;
  for (const Entry& entry : this->Open)
  {
    const State& here = this->state(entry.node);
    if (!here.settled)
    {
      open.push_back({ here.distance + this->ahead(entry.node, target.position), entry.node });
    }
  }
  this->Open = std::move(open);
  std::make_heap(this->Open.begin(), this->Open.end());
}

void PathSearch::lookFrom(Index node, const Point3& target)
{
  const WayLength distance = this->state(node).distance;
  for (const PathGraph::Way& way : this->Graph.from(node))
  {
    if (this->Taken == PathWays::Edges && way.crossed != none)
    {
      continue;
    }
    State& there = this->state(way.node);
    const WayLength length = distance + way.length;
    if (length < there.distance)
    {
      there = { length, node, false };
      this->Open.push_back({ length + this->ahead(way.node, target), way.node });
      std::push_heap(this->Open.begin(), this->Open.end());
    }
    else if (length == there.distance && there.before != none &&
      this->Graph.vertex(node) < this->Graph.vertex(there.before))
    {
      there.before = node;
    }
  }
}

Index PathSearch::lastNode(const SurfacePoint& target)
{
  const Indices goals = nodesAround(this->Graph, target);
  this->aimAt(target, goals);
  Index last = none;
  WayLength best = std::numeric_limits<WayLength>::max();
  const auto offer = [&](Index node) {
    const State& here = this->state(node);
    const WayLength length = here.distance + apart(this->Graph, node, target);
    if (here.settled &&
      (length < best || (length == best && this->Graph.vertex(node) < this->Graph.vertex(last))))
    {
      best = length;
      last = node;
    }
  };
  std::for_each(goals.begin(), goals.end(), offer);
  while (!this->Open.empty() && (last == none || this->Open.front().bound <= best + roundingOfWays))
  {
    const Index node = this->Open.front().node;
    std::pop_heap(this->Open.begin(), this->Open.end());
    this->Open.pop_back();
    State& here = this->state(node);
    if (!here.settled)
    {
      here.settled = true;
      this->lookFrom(node, target.position);
      if (std::find(goals.begin(), goals.end(), node) != goals.end())
      {
        offer(node);
      }
    }
  }
  return last;
}

Indices PathSearch::chainTo(Index node)
{
  Indices chain;
  for (Index n = node; n != none; n = this->state(n).before)
  {
    chain.push_back(n);
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

Index PathSearch::crossedBetween(Index from, Index to) const
{
  const PathGraph::Way* best = nullptr;
  for (const PathGraph::Way& way : this->Graph.from(from))
  {
    if (way.node == to && (this->Taken == PathWays::All || way.crossed == none) &&
      (!best || way.length < best->length))
    {
      best = &way;
    }
  }
  return best->crossed;
}

PathCourse PathSearch::courseTo(const SurfacePoint& target)
{
  const TriangleMesh& mesh = this->Graph.mesh();
  const Index last = this->lastNode(target);
  if (last == none)
  {
    return {};
  }
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
  Index before = none;
  for (const Index node : this->chainTo(last))
  {
    if (before != none || this->Source.carrier != Carrier::Vertex)
    {
      const Index crossed = before != none ? this->crossedBetween(before, node) : none;
      append(vertexPoint(mesh, this->Graph.vertex(node)),
        crossed != none ? Indices{ crossed } : Indices());
    }
    before = node;
  }
  if (target.carrier != Carrier::Vertex || course.legs.empty())
  {
    append(target, {});
  }
  return course;
}
}
