// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/BoundaryRuler.h"

#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// Places this near to a vertex, in edge lengths, are the vertex.
constexpr double snapFraction = 1e-3;
/// Places whose distances differ by less, in squares of a boundary's length, are equally near.
constexpr double equallyNear = 1e-18;
}

BoundaryRuler::BoundaryRuler(const TriangleMesh& mesh)
  : Mesh(mesh)
  , Places(mesh.vertexCount())
{
  for (Indices& halfedges : mesh.boundaryLoops())
  {
    Loop loop;
    double arc = 0.0;
    for (Index h : halfedges)
    {
      const Index v = mesh.from(h);
      this->Places[v] = { static_cast<Index>(this->Loops.size()), arc };
      if (pi - angleSum(mesh, v) > cornerTurn)
      {
        loop.corners.push_back(arc);
      }
      loop.arcs.push_back(arc);
      arc += mesh.length(h);
    }
    loop.halfedges = std::move(halfedges);
    loop.arcs.push_back(arc);
    this->Loops.push_back(std::move(loop));
  }
}

BoundaryPlace BoundaryRuler::moved(const BoundaryPlace& place, double by) const
{
  const double length = this->length(place.loop);
  const double arc = std::fmod(place.arc + by, length);
  return { place.loop, arc < 0.0 ? arc + length : arc };
}

std::size_t BoundaryRuler::edgeAt(const BoundaryPlace& place) const
{
  const std::vector<double>& arcs = this->Loops[place.loop].arcs;
  const auto after = std::upper_bound(arcs.begin() + 1, arcs.end() - 1, place.arc);
  return static_cast<std::size_t>(after - arcs.begin()) - 1;
}

SurfacePoint BoundaryRuler::surfacePoint(const BoundaryPlace& place) const
{
  const Loop& loop = this->Loops[place.loop];
  const std::size_t k = this->edgeAt(place);
  const double length = loop.arcs[k + 1] - loop.arcs[k];
  const double fraction = std::clamp((place.arc - loop.arcs[k]) / length, 0.0, 1.0);
  const Index h = loop.halfedges[k];
  return std::min(fraction, 1.0 - fraction) < snapFraction
    ? vertexPoint(this->Mesh, fraction < 0.5 ? this->Mesh.from(h) : this->Mesh.to(h))
    : edgePoint(this->Mesh, h, fraction);
}

Point3 BoundaryRuler::point(const BoundaryPlace& place) const
{
  return this->surfacePoint(place).position;
}

Point3 BoundaryRuler::inside(const BoundaryPlace& place) const
{
  return this->Mesh.centroid(this->Loops[place.loop].halfedges[this->edgeAt(place)] / 3);
}

Index BoundaryRuler::vertex(const BoundaryPlace& place) const
{
  const Loop& loop = this->Loops[place.loop];
  const std::size_t k = this->edgeAt(place);
  const bool first = place.arc - loop.arcs[k] <= loop.arcs[k + 1] - place.arc;
  return first ? this->Mesh.from(loop.halfedges[k]) : this->Mesh.to(loop.halfedges[k]);
}

BoundaryPlace BoundaryRuler::nearest(const Point3& point, const Point3& inside) const
{
  BoundaryPlace best;
  double least = std::numeric_limits<double>::infinity();
  double leastMiss = 0.0;
  for (Index l = 0; l < this->loopCount(); ++l)
  {
    const Loop& loop = this->Loops[l];
    const double equal = equallyNear * this->length(l) * this->length(l);
    for (std::size_t k = 0; k < loop.halfedges.size(); ++k)
    {
      const Index h = loop.halfedges[k];
      const Point3& a = this->Mesh.point(this->Mesh.from(h));
      const Point3& b = this->Mesh.point(this->Mesh.to(h));
      const double fraction = fractionAlong(a, b, point);
      const double distance = (a + fraction * (b - a) - point).squaredNorm();
      if (distance > least + equal)
      {
        continue;
      }
      const double miss = (this->Mesh.centroid(h / 3) - inside).squaredNorm();
      if (distance < least - equal || miss < leastMiss)
      {
        best = { l, loop.arcs[k] + fraction * (loop.arcs[k + 1] - loop.arcs[k]) };
        least = std::min(least, distance);
        leastMiss = miss;
      }
    }
  }
  return best;
}

double BoundaryRuler::distance(const BoundaryPlace& a, const BoundaryPlace& b) const
{
  if (a.loop != b.loop)
  {
    return std::numeric_limits<double>::infinity();
  }
  const double way = std::abs(a.arc - b.arc);
  return std::min(way, this->length(a.loop) - way);
}

Indices BoundaryRuler::spread(double spacing, double clear) const
{
  Indices result;
  for (Index l = 0; l < this->loopCount(); ++l)
  {
    const Loop& loop = this->Loops[l];
    double next = 0.0;
    for (std::size_t k = 0; k < loop.halfedges.size(); ++k)
    {
      const BoundaryPlace here{ l, loop.arcs[k] };
      const bool nearCorner =
        std::any_of(loop.corners.begin(), loop.corners.end(), [&](double corner) {
          return this->distance(here, { l, corner }) < clear;
        });
      if (!nearCorner && loop.arcs[k] >= next)
      {
        result.push_back(this->Mesh.from(loop.halfedges[k]));
        next = loop.arcs[k] + spacing;
      }
    }
  }
  return result;
}
}
