// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/ConstrainedDelaunay.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace flattening
{
namespace
{
std::array<Index, 2> key(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}
}

/// True where the vertex lies on the segment within the snap distance, neither before its start nor
/// behind its end, and nearer to its end.
bool ConstrainedDelaunay::passes(Index start, Index end, Index vertex) const
{
  const Point2& a = this->Positions[start];
  const Point2& v = this->Positions[vertex];
  const Point2 way = this->Positions[end] - a;
  const double length = way.norm();
  const double along = way.dot(v - a);
  return along > 0.0 && along < length * length && (v - this->Positions[end]).norm() < length &&
    std::abs(this->orient(start, end, vertex)) <= this->Snap * length;
}

Index ConstrainedDelaunay::neighbourOnTheWay(Index start, Index end) const
{
  Index nearest = none;
  double least = std::numeric_limits<double>::infinity();
  for (Index h : this->outgoing(start))
  {
    for (Index v : { this->to(h), this->apex(h) })
    {
      const double distance = (this->Positions[v] - this->Positions[start]).norm();
      if (v != end && distance < least && this->passes(start, end, v))
      {
        nearest = v;
        least = distance;
      }
    }
  }
  return nearest;
}

/// The half-edge opposite to the start that the way to the end crosses, from right to left.
Index ConstrainedDelaunay::firstCrossed(Index start, Index end) const
{
  Index best = none;
  double most = -std::numeric_limits<double>::infinity();
  for (Index h : this->outgoing(start))
  {
    const Index right = this->to(h);
    const Index left = this->apex(h);
    const double toRight = (this->Positions[right] - this->Positions[start]).norm();
    const double toLeft = (this->Positions[left] - this->Positions[start]).norm();
    const double inside =
      std::min(this->orient(start, right, end) / toRight, this->orient(start, end, left) / toLeft);
    if (inside > most)
    {
      most = inside;
      best = next(h);
    }
  }
  return best;
}

/// Puts a vertex where the way from start to end crosses an edge.
Index ConstrainedDelaunay::crossEdge(Index h, Index start, Index end)
{
  const Index p = this->from(h);
  const Index q = this->to(h);
  const double right = std::max(-this->orient(start, end, p), 0.0);
  const double left = std::max(this->orient(start, end, q), 0.0);
  if (!(right + left > 0.0))
  {
    return none;
  }
  const double s = right / (right + left);
  Weights weights{};
  for (int k = 0; k < 3; ++k)
  {
    weights[k] = (1.0 - s) * this->weights(p)[k] + s * this->weights(q)[k];
  }
  const bool fixed = this->Fixed[h] != 0;
  const Index vertex = this->addVertex(weights);
  this->splitEdge(h, vertex);
  if (fixed)
  {
    this->Splits[key(p, q)] = vertex;
  }
  return vertex;
}

/// Flips the edges between start and end away (S. W. Sloan, Computers & Structures 47(3), 1993,
/// 441-450), until an edge joins the two.
bool ConstrainedDelaunay::recover(
  Index start, Index end, const std::vector<std::array<Index, 2>>& crossed)
{
  std::deque<std::array<Index, 2>> queue(crossed.begin(), crossed.end());
  std::size_t left = 100 + std::min<std::size_t>(crossed.size(), 1000) * crossed.size();
  while (!queue.empty() && left-- > 0)
  {
    const std::array<Index, 2> edge = queue.front();
    queue.pop_front();
    const Index h = this->find(edge[0], edge[1]);
    if (h == none)
    {
      return false;
    }
    if (!this->canFlip(h))
    {
      queue.push_back(edge);
      continue;
    }
    const Index l = this->apex(h);
    const Index r = this->apex(this->Twins[h]);
    this->flip(h);
    const bool touches = l == start || l == end || r == start || r == end;
    if (!touches && (this->orient(start, end, l) > 0.0) != (this->orient(start, end, r) > 0.0))
    {
      queue.push_back({ l, r });
    }
  }
  return this->find(start, end) != none;
}

/// Makes the first stretch of the way from start to end an edge, and returns where that ends: at
/// the end, at a vertex on the way, or at a crossing. none where rounding prevents it.
Index ConstrainedDelaunay::advance(Index start, Index end, bool flipping)
{
  Index h = this->find(start, end);
  if (h != none && this->Fixed[h])
  {
    return end;
  }
  const Index neighbour = this->neighbourOnTheWay(start, end);
  if (neighbour != none || h != none)
  {
    const Index target = neighbour != none ? neighbour : end;
    this->fix(this->find(start, target));
    return target;
  }
  std::vector<std::array<Index, 2>> crossed;
  Index target = none;
  for (h = this->firstCrossed(start, end); target == none;)
  {
    const Index twin = this->Twins[h];
    if (twin == none)
    {
      return none;
    }
    if (this->Fixed[h] || !flipping)
    {
      target = this->crossEdge(h, start, end);
      if (target == none)
      {
        return none;
      }
      break;
    }
    crossed.push_back({ this->from(h), this->to(h) });
    const Index ahead = this->apex(twin);
    if (ahead == end || this->passes(start, end, ahead))
    {
      target = ahead;
    }
    h = this->orient(start, end, ahead) > 0.0 ? next(twin) : previous(twin);
  }
  if (!crossed.empty() && !this->recover(start, target, crossed))
  {
    // Free edges that cannot be flipped away are split like the others.
    return flipping ? this->advance(start, end, false) : none;
  }
  h = this->find(start, target);
  if (h == none)
  {
    return none;
  }
  this->fix(h);
  return target;
}

bool ConstrainedDelaunay::addSegment(Index from, Index to)
{
  if (from == to || this->Segments.count({ from, to }) || this->Segments.count({ to, from }))
  {
    return true;
  }
  Indices path{ from };
  while (path.back() != to)
  {
    const Index reached = this->advance(path.back(), to, true);
    if (reached == none || path.size() > this->Cells.size() + 10)
    {
      return false;
    }
    path.push_back(reached);
  }
  this->Segments[{ from, to }] = std::move(path);
  return true;
}

Indices ConstrainedDelaunay::chain(Index from, Index to) const
{
  auto found = this->Segments.find({ from, to });
  const bool backward = found == this->Segments.end();
  if (backward)
  {
    found = this->Segments.find({ to, from });
  }
  if (found == this->Segments.end())
  {
    return { from };
  }
  Indices vertices;
  // What is still to be visited, the next one last.
  Indices stack(found->second.rbegin(), found->second.rend());
  while (!stack.empty())
  {
    const Index vertex = stack.back();
    const auto split =
      vertices.empty() ? this->Splits.end() : this->Splits.find(key(vertices.back(), vertex));
    if (split != this->Splits.end())
    {
      stack.push_back(split->second);
      continue;
    }
    vertices.push_back(vertex);
    stack.pop_back();
  }
  if (backward)
  {
    std::reverse(vertices.begin(), vertices.end());
  }
  return vertices;
}
}
