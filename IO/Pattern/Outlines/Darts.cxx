// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/Darts.h"

#include <algorithm>

namespace flattening::pattern
{
namespace
{
/// One loop with its edges' wires.
struct Loop
{
  const Indices& points;
  const SewnPartners& partners;
  std::vector<const SourceWire*> wire; ///< null: of none

  std::size_t size() const { return this->points.size(); }
  Index point(std::size_t k) const { return this->points[k % this->size()]; }
  Index dart(std::size_t k) const
  {
    const SourceWire* const own = this->wire[k % this->size()];
    return own && own->type == WireType::Dart ? own->curve : none;
  }
  /// Whether edge a is sewn to edge b, which runs the other way round.
  bool sewn(std::size_t a, std::size_t b) const
  {
    const auto found = this->partners.find(edgeKey(this->point(a), this->point(a + 1)));
    return found != this->partners.end() && found->second[0] == this->point(b + 1) &&
      found->second[1] == this->point(b);
  }
};

/// Whether the edges first .. first + count - 1 are two legs that meet in the middle.
bool folds(const Loop& loop, std::size_t first, std::size_t count)
{
  for (std::size_t k = 0; k < count / 2; ++k)
  {
    if (!loop.sewn(first + k, first + count - 1 - k))
    {
      return false;
    }
  }
  return count % 2 == 0;
}

/// The dart whose legs are edges of a loop, from one mouth or tip to the other.
Dart dartOf(const Loop& loop, std::size_t loopIndex, std::size_t first, std::size_t edges)
{
  const std::size_t firstEdge = first % loop.size();
  return { loopIndex, firstEdge, edges, loop.point(first + edges / 2), loop.wire[firstEdge]->name };
}

void findOpenDarts(const Loop& loop, std::size_t loopIndex, std::vector<Dart>& darts)
{
  const std::size_t count = loop.size();
  std::size_t start = 0;
  while (start < count && loop.dart(start) == loop.dart(start + count - 1))
  {
    ++start;
  }
  for (std::size_t k = start; k < start + count;)
  {
    const Index curve = loop.dart(k);
    std::size_t end = k + 1;
    while (end < start + count && loop.dart(end) == curve)
    {
      ++end;
    }
    if (curve != none && end - k < count && folds(loop, k, end - k))
    {
      darts.push_back(dartOf(loop, loopIndex, k, end - k));
      darts.back().mouth = { loop.point(k), loop.point(end) };
    }
    k = end;
  }
}

/// A hole that is one dart with a tip at both ends.
void findClosedDart(const Loop& loop, std::size_t loopIndex, std::vector<Dart>& darts)
{
  const std::size_t count = loop.size();
  bool isDart = true;
  for (std::size_t k = 0; k < count; ++k)
  {
    isDart = isDart && loop.dart(k) != none && loop.dart(k) == loop.dart(0);
  }
  for (std::size_t k = 0; isDart && k < count; ++k)
  {
    if (folds(loop, k, count))
    {
      darts.push_back(dartOf(loop, loopIndex, k, count));
      darts.back().otherTip = loop.point(k);
      return;
    }
  }
}

Point2 mirrored(const Point2& direction, const Point2& axis)
{
  const Point2 unit = axis.normalized();
  return 2.0 * unit.dot(direction) * unit - direction;
}
}

WireOfEdge wiresOfEdges(const PatternSource& source)
{
  WireOfEdge wires;
  for (const bool boundary : { false, true })
  {
    for (std::size_t w = 0; w < source.wires.size(); ++w)
    {
      const SourceWire& wire = source.wires[w];
      if ((wire.type == WireType::Boundary) != boundary)
      {
        continue;
      }
      for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
      {
        wires.emplace(undirectedKey(wire.points[k], wire.points[k + 1]), w);
      }
    }
  }
  return wires;
}

const SourceWire* wireOf(const PatternSource& source, const WireOfEdge& wires, Index from, Index to)
{
  const auto found = wires.find(undirectedKey(from, to));
  return found == wires.end() ? nullptr : &source.wires[found->second];
}

std::vector<Dart> findDarts(const PatternSource& source, const std::vector<Indices>& loops,
  const WireOfEdge& wires, const SewnPartners& partners)
{
  std::vector<Dart> darts;
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    Loop loop{ loops[l], partners, {} };
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      loop.wire.push_back(wireOf(source, wires, loop.point(k), loop.point(k + 1)));
    }
    findOpenDarts(loop, l, darts);
    if (l > 0)
    {
      findClosedDart(loop, l, darts);
    }
  }
  return darts;
}

bool dartRoof(const Point2& tip, const std::array<Point2, 2>& mouth,
  const std::array<Point2, 2>& neighbour, Point2& corner)
{
  const Point2 middle = (mouth[0] + mouth[1]) / 2.0 - tip;
  const double leg = ((mouth[0] - tip).norm() + (mouth[1] - tip).norm()) / 2.0;
  const double width = (mouth[1] - mouth[0]).norm();
  if (width < 1e-6 * leg || middle.norm() < 0.5 * leg)
  {
    return false;
  }
  const Point2 fold = middle.normalized();
  double height = 0.0; // of the corner over the tip, enough for either side to fold to
  for (int side = 0; side < 2; ++side)
  {
    const Point2 edge = mirrored(neighbour[side] - mouth[side], mouth[side] - tip);
    const double sine = cross(fold, edge);
    const Point2 arm = mouth[side] - tip;
    const double at = cross(arm, edge) / sine;
    if (!(at > 0.5 * leg && at < 1.5 * leg))
    {
      return false;
    }
    height = std::max(height, at);
  }
  corner = tip + height * fold;
  return true;
}

double foldMiss(const Points2& legs)
{
  const Point2& tip = legs[legs.size() / 2];
  const Point2 fold = (legs.front() + legs.back()) / 2.0 - tip;
  double most = 0.0;
  for (std::size_t k = 0; k < legs.size() / 2; ++k)
  {
    const Point2 folded = tip + mirrored(legs[k] - tip, fold);
    most = std::max(most, (folded - legs[legs.size() - 1 - k]).norm());
  }
  return most;
}
}
