// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/BoundaryOverlap.h"

#include "Base/Orientation.h"
#include "Base/Types.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
using Box = Eigen::AlignedBox2d;

/// A boundary edge after its ends were moved inwards.
struct Side
{
  Index halfedge;
  Index from;
  Index to;
  Point2 start;
  Point2 end;
};

/// The vertex moved along the bisector of its planar angle into the surface.
///
/// The angle is summed over the triangles, so that it is right up to 2 pi (the tip of a closed cut)
/// and beyond, where the neighbours' positions alone would not tell inside from outside.
Point2 moveInwards(
  const TriangleMesh& mesh, const Points2& positions, Index vertex, double distance)
{
  const Point2& apex = positions[vertex];
  const Index first = mesh.outgoing(vertex);
  double angle = 0.0;
  for (Index h : VertexFan(mesh, vertex))
  {
    const Point2 u = positions[mesh.to(h)] - apex;
    const Point2 v = positions[mesh.from(TriangleMesh::previous(h))] - apex;
    const Point2 opposite = v - u;
    const double doubleArea = cross(u, v);
    angle += std::atan2(doubleArea, u.dot(v));
    const double longest =
      std::sqrt(std::max({ u.squaredNorm(), v.squaredNorm(), opposite.squaredNorm() }));
    if (longest > 0.0)
    {
      distance = std::min(distance, 0.1 * std::abs(doubleArea) / longest);
    }
  }
  const Point2 along = positions[mesh.to(first)] - apex;
  const double length = along.norm();
  if (!(length > 0.0))
  {
    return apex;
  }
  return apex + Eigen::Rotation2Dd(0.5 * angle) * along * (distance / length);
}

/// Boxes around runs of sides, halved down to single sides. A boundary loop is local in its order,
/// so the tree needs no sorting.
class SideTree
{
public:
  /// \param last the overlap after which no more are looked for
  SideTree(const std::vector<Side>& sides, std::size_t listed, std::size_t last, std::size_t visits)
    : Sides(sides)
    , MostListed(listed)
    , Last(last)
    , VisitsLeft(visits)
    , Boxes(4 * sides.size())
  {
    this->build(1, 0, sides.size());
  }

  BoundaryOverlaps crossings()
  {
    this->inside(1, 0, this->Sides.size());
    std::sort(this->Found.listed.begin(), this->Found.listed.end());
    return std::move(this->Found);
  }

private:
  void build(std::size_t node, std::size_t begin, std::size_t end)
  {
    if (end - begin == 1)
    {
      this->Boxes[node].extend(this->Sides[begin].start);
      this->Boxes[node].extend(this->Sides[begin].end);
      return;
    }
    const std::size_t middle = (begin + end) / 2;
    this->build(2 * node, begin, middle);
    this->build(2 * node + 1, middle, end);
    this->Boxes[node] = this->Boxes[2 * node].merged(this->Boxes[2 * node + 1]);
  }

  void inside(std::size_t node, std::size_t begin, std::size_t end)
  {
    if (end - begin < 2)
    {
      return;
    }
    const std::size_t middle = (begin + end) / 2;
    this->inside(2 * node, begin, middle);
    this->inside(2 * node + 1, middle, end);
    this->between(2 * node, begin, middle, 2 * node + 1, middle, end);
  }

  void between(std::size_t a, std::size_t aBegin, std::size_t aEnd, std::size_t b,
    std::size_t bBegin, std::size_t bEnd)
  {
    if (this->Found.count >= this->Last || !this->Found.complete)
    {
      return;
    }
    if (this->VisitsLeft == 0)
    {
      this->Found.complete = false;
      return;
    }
    --this->VisitsLeft;
    if (!this->Boxes[a].intersects(this->Boxes[b]))
    {
      return;
    }
    if (aEnd - aBegin == 1 && bEnd - bBegin == 1)
    {
      this->test(this->Sides[aBegin], this->Sides[bBegin]);
    }
    else if (aEnd - aBegin >= bEnd - bBegin)
    {
      const std::size_t middle = (aBegin + aEnd) / 2;
      this->between(2 * a, aBegin, middle, b, bBegin, bEnd);
      this->between(2 * a + 1, middle, aEnd, b, bBegin, bEnd);
    }
    else
    {
      const std::size_t middle = (bBegin + bEnd) / 2;
      this->between(a, aBegin, aEnd, 2 * b, bBegin, middle);
      this->between(a, aBegin, aEnd, 2 * b + 1, middle, bEnd);
    }
  }

  void test(const Side& a, const Side& b)
  {
    const bool adjacent = a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
    if (!adjacent && segmentsMeet(a.start, a.end, b.start, b.end))
    {
      ++this->Found.count;
      if (this->Found.listed.size() < this->MostListed)
      {
        this->Found.listed.push_back(
          { std::min(a.halfedge, b.halfedge), std::max(a.halfedge, b.halfedge) });
      }
    }
  }

  const std::vector<Side>& Sides;
  std::size_t MostListed;
  std::size_t Last;
  std::size_t VisitsLeft;
  std::vector<Box> Boxes;
  BoundaryOverlaps Found;
};

std::vector<Side> contractedSides(
  const TriangleMesh& mesh, const Points2& positions, double contact)
{
  std::vector<Side> sides;
  for (const Indices& loop : mesh.boundaryLoops())
  {
    Box box;
    for (Index h : loop)
    {
      box.extend(positions[mesh.from(h)]);
    }
    const double distance = contact * box.diagonal().norm();
    const std::size_t begin = sides.size();
    for (Index h : loop)
    {
      const Point2 start = moveInwards(mesh, positions, mesh.from(h), distance);
      sides.push_back({ h, mesh.from(h), mesh.to(h), start, start });
    }
    for (std::size_t i = begin; i < sides.size(); ++i)
    {
      sides[i].end = sides[i + 1 < sides.size() ? i + 1 : begin].start;
    }
  }
  return sides;
}
}

BoundaryOverlaps countBoundaryOverlaps(const TriangleMesh& mesh, const Points2& positions,
  std::size_t most, double contact, std::size_t maxVisits)
{
  const std::vector<Side> sides = contractedSides(mesh, positions, contact);
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  return sides.size() < 2 ? BoundaryOverlaps() : SideTree(sides, most, all, maxVisits).crossings();
}

std::vector<std::array<Index, 2>> findBoundaryOverlaps(
  const TriangleMesh& mesh, const Points2& positions, std::size_t most, double contact)
{
  const std::vector<Side> sides = contractedSides(mesh, positions, contact);
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  return sides.size() < 2 ? std::vector<std::array<Index, 2>>()
                          : SideTree(sides, most, most, all).crossings().listed;
}
}
