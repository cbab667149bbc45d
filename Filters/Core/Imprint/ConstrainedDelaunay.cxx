// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/ConstrainedDelaunay.h"

#include "Base/Types.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace flattening
{
ConstrainedDelaunay::ConstrainedDelaunay(
  const Point3& a, const Point3& b, const Point3& c, double snap)
  : Corners(3)
{
  // Flat coordinates with the longest side as the x axis and of length one: the heights of a thin
  // triangle keep their relative precision, and nothing depends on the unit of length.
  const std::array<Point3, 3> p{ a, b, c };
  int base = 0;
  for (int k = 1; k < 3; ++k)
  {
    if ((p[(k + 1) % 3] - p[k]).norm() > (p[(base + 1) % 3] - p[base]).norm())
    {
      base = k;
    }
  }
  const Point3 x = p[(base + 1) % 3] - p[base];
  const Point3 y = p[(base + 2) % 3] - p[base];
  const double length = x.norm();
  const Point3 u = x / length;
  this->Corners[base] = Point2(0.0, 0.0);
  this->Corners[(base + 1) % 3] = Point2(1.0, 0.0);
  this->Corners[(base + 2) % 3] = Point2(u.dot(y), u.cross(y).norm()) / length;
  this->Snap = snap / length;
  for (int k = 0; k < 3; ++k)
  {
    Weights weights{ 0.0, 0.0, 0.0 };
    weights[k] = 1.0;
    this->addVertex(weights);
  }
  this->addTriangle();
  this->setTriangle(0, { 0, none, true }, { 1, none, true }, { 2, none, true });
}

Point2 ConstrainedDelaunay::position(const Weights& w) const
{
  return w[0] * this->Corners[0] + w[1] * this->Corners[1] + w[2] * this->Corners[2];
}

double ConstrainedDelaunay::orient(Index a, Index b, Index c) const
{
  const Point2& p = this->Positions[a];
  return cross(this->Positions[b] - p, this->Positions[c] - p);
}

/// Not by exact signs of the rounded positions: these make slivers of three points of a side, and
/// one of 20,000 random triangulations fails.
bool ConstrainedDelaunay::surelyPositive(Index a, Index b, Index c) const
{
  const Point2 u = this->Positions[b] - this->Positions[a];
  const Point2 v = this->Positions[c] - this->Positions[a];
  const double size = std::abs(u.x() * v.y()) + std::abs(u.y() * v.x());
  return cross(u, v) > 16.0 * std::numeric_limits<double>::epsilon() * size;
}

Index ConstrainedDelaunay::addVertex(const Weights& weights)
{
  this->VertexWeights.push_back(weights);
  this->Positions.push_back(this->position(weights));
  this->Outgoing.push_back(none);
  return this->vertexCount() - 1;
}

Index ConstrainedDelaunay::addTriangle()
{
  this->Cells.push_back({ none, none, none });
  this->Twins.resize(this->Twins.size() + 3, none);
  this->Fixed.resize(this->Fixed.size() + 3, 0);
  return static_cast<Index>(this->Cells.size()) - 1;
}

void ConstrainedDelaunay::setTriangle(Index t, const Side& a, const Side& b, const Side& c)
{
  const std::array<Side, 3> sides{ a, b, c };
  for (int k = 0; k < 3; ++k)
  {
    const Index h = 3 * t + k;
    this->Cells[t][k] = sides[k].vertex;
    this->Twins[h] = sides[k].twin;
    this->Fixed[h] = sides[k].fixed ? 1 : 0;
    if (sides[k].twin != none)
    {
      this->Twins[sides[k].twin] = h;
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    const Index h = 3 * t + k;
    Index& outgoing = this->Outgoing[sides[k].vertex];
    const bool stale = outgoing == none || this->from(outgoing) != sides[k].vertex;
    if (stale || this->Twins[h] == none || this->Twins[outgoing] != none)
    {
      outgoing = h;
    }
  }
}

Indices ConstrainedDelaunay::outgoing(Index vertex) const
{
  Indices fan;
  const Index first = this->Outgoing[vertex];
  for (Index h = first; h != none;)
  {
    fan.push_back(h);
    h = this->counterClockwise(h);
    if (h == first)
    {
      break;
    }
  }
  return fan;
}

/// Either half-edge between two vertices, preferably the one from the first to the second.
Index ConstrainedDelaunay::find(Index fromVertex, Index toVertex) const
{
  for (Index h : this->outgoing(fromVertex))
  {
    if (this->to(h) == toVertex)
    {
      return h;
    }
    if (this->apex(h) == toVertex && this->Twins[previous(h)] == none)
    {
      return previous(h);
    }
  }
  return none;
}

void ConstrainedDelaunay::fix(Index h)
{
  this->Fixed[h] = 1;
  if (this->Twins[h] != none)
  {
    this->Fixed[this->Twins[h]] = 1;
  }
}

/// One triangle becomes three around a vertex inside.
void ConstrainedDelaunay::splitTriangle(Index t, Index vertex)
{
  const Side a = this->side(3 * t);
  const Side b = this->side(3 * t + 1);
  const Side c = this->side(3 * t + 2);
  const Index u = this->addTriangle();
  const Index v = this->addTriangle();
  this->setTriangle(t, a, { b.vertex, 3 * u + 2, false }, { vertex, 3 * v + 1, false });
  this->setTriangle(u, b, { c.vertex, 3 * v + 2, false }, { vertex, 3 * t + 1, false });
  this->setTriangle(v, c, { a.vertex, 3 * t + 2, false }, { vertex, 3 * u + 1, false });
}

/// The triangles at an edge become two each; both halves of the edge stay as fixed as it was.
void ConstrainedDelaunay::splitEdge(Index h, Index vertex)
{
  const Index other = this->Twins[h];
  const Side edge = this->side(h);
  const Side after = this->side(next(h));
  const Side before = this->side(previous(h));
  const Index t = h / 3;               // from - vertex - apex
  const Index u = this->addTriangle(); // vertex - to - apex
  Index s = none;                      // to - vertex - apex on the other side
  Index v = none;                      // vertex - from - apex on the other side
  Side otherAfter{ none, none, false };
  Side otherBefore{ none, none, false };
  if (other != none)
  {
    otherAfter = this->side(next(other));
    otherBefore = this->side(previous(other));
    s = other / 3;
    v = this->addTriangle();
  }
  this->setTriangle(
    t, { edge.vertex, v == none ? none : 3 * v, edge.fixed }, { vertex, 3 * u + 2, false }, before);
  this->setTriangle(u, { vertex, s == none ? none : 3 * s, edge.fixed }, after,
    { before.vertex, 3 * t + 1, false });
  if (other != none)
  {
    this->setTriangle(
      s, { after.vertex, 3 * u, edge.fixed }, { vertex, 3 * v + 2, false }, otherBefore);
    this->setTriangle(
      v, { vertex, 3 * t, edge.fixed }, otherAfter, { otherBefore.vertex, 3 * s + 1, false });
  }
}

bool ConstrainedDelaunay::canFlip(Index h) const
{
  const Index twin = this->Twins[h];
  return !this->Fixed[h] && twin != none &&
    this->surelyPositive(this->apex(h), this->from(h), this->apex(twin)) &&
    this->surelyPositive(this->apex(twin), this->to(h), this->apex(h));
}

void ConstrainedDelaunay::flip(Index h)
{
  const Index twin = this->Twins[h];
  const Side qToL = this->side(next(h));
  const Side lToP = this->side(previous(h));
  const Side pToR = this->side(next(twin));
  const Side rToQ = this->side(previous(twin));
  const Index t = h / 3;
  const Index u = twin / 3;
  // t: l - p - r, u: r - q - l.
  this->setTriangle(t, lToP, pToR, { rToQ.vertex, 3 * u + 2, false });
  this->setTriangle(u, rToQ, qToL, { lToP.vertex, 3 * t + 2, false });
}

/// Lawson's flips, from the given half-edges on.
void ConstrainedDelaunay::makeDelaunay(Indices stack)
{
  // In exact arithmetic flips end by themselves; the limit guards against rounding.
  std::size_t left = 100 * this->Cells.size() + 1000;
  while (!stack.empty() && left-- > 0)
  {
    const Index h = stack.back();
    stack.pop_back();
    if (this->Fixed[h] || this->Twins[h] == none)
    {
      continue;
    }
    const Point2& p = this->Positions[this->from(h)];
    const Point2& q = this->Positions[this->to(h)];
    const Point2& l = this->Positions[this->apex(h)];
    const Point2& r = this->Positions[this->apex(this->Twins[h])];
    // The two opposite angles sum to more than pi where cot + cot < 0.
    const double left1 = (p - l).dot(q - l) * cross(q - r, p - r);
    const double right1 = (p - r).dot(q - r) * cross(p - l, q - l);
    if (left1 + right1 < -1e-12 * (std::abs(left1) + std::abs(right1)) && this->canFlip(h))
    {
      const Index t = h / 3;
      const Index u = this->Twins[h] / 3;
      this->flip(h);
      for (Index k : { 3 * t, 3 * t + 1, 3 * u, 3 * u + 1 })
      {
        stack.push_back(k);
      }
    }
  }
}

void ConstrainedDelaunay::refine()
{
  Indices all;
  for (std::size_t h = 0; h < this->Twins.size(); ++h)
  {
    all.push_back(static_cast<Index>(h));
  }
  this->makeDelaunay(std::move(all));
}

Index ConstrainedDelaunay::addSidePoint(int side, double fraction)
{
  Weights weights{ 0.0, 0.0, 0.0 };
  weights[side] = 1.0 - fraction;
  weights[(side + 1) % 3] = fraction;
  const Index vertex = this->addVertex(weights);
  this->splitEdge(this->Outgoing[this->LastOnSide[side]], vertex);
  this->LastOnSide[side] = vertex;
  return vertex;
}

/// The triangle that a walk towards the point ends in, from the newest one on.
Index ConstrainedDelaunay::locate(const Point2& point) const
{
  Index t = static_cast<Index>(this->Cells.size()) - 1;
  for (std::size_t steps = 0; steps < this->Cells.size(); ++steps)
  {
    Index through = none;
    double least = 0.0;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      const Point2& from = this->Positions[this->from(h)];
      const double side = cross(this->Positions[this->to(h)] - from, point - from);
      if (side < least && this->Twins[h] != none)
      {
        least = side;
        through = this->Twins[h];
      }
    }
    if (through == none)
    {
      break;
    }
    t = through / 3;
  }
  return t;
}

Index ConstrainedDelaunay::addPoint(const Weights& weights)
{
  const Point2 point = this->position(weights);
  Index nearest = none;
  double least = this->Snap;
  for (Index v = 0; v < this->vertexCount(); ++v)
  {
    const double distance = (this->Positions[v] - point).norm();
    if (distance <= least)
    {
      least = distance;
      nearest = v;
    }
  }
  if (nearest != none)
  {
    return nearest;
  }
  const Index t = this->locate(point);
  const Index vertex = this->addVertex(weights);
  // A point on an edge, to rounding, splits the edge.
  Index edge = none;
  for (Index h = 3 * t; h < 3 * t + 3; ++h)
  {
    if (this->Twins[h] != none && !this->surelyPositive(this->from(h), this->to(h), vertex))
    {
      edge = h;
    }
  }
  if (edge != none)
  {
    this->splitEdge(edge, vertex);
  }
  else
  {
    this->splitTriangle(t, vertex);
  }
  Indices link;
  for (Index h : this->outgoing(vertex))
  {
    link.push_back(next(h));
  }
  this->makeDelaunay(std::move(link));
  return vertex;
}

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
Index ConstrainedDelaunay::advance(Index start, Index end)
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
    if (this->Fixed[h])
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
  h = crossed.empty() || this->recover(start, target, crossed) ? this->find(start, target) : none;
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
    const Index reached = this->advance(path.back(), to);
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
