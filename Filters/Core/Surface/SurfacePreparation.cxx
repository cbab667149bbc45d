// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfacePreparation.h"

#include "Base/Memory.h"
#include "Base/Status.h"
#include "Base/Types.h"
#include "Surface/TriangleMesh.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace flattening
{
namespace
{
/// Turns triangles over until neighbours agree. Returns the triangles of a one-sided band, if any.
/// \param partner of each half-edge, before that.
Indices turnOver(Triangles& triangles, const Indices& partner, Indices& reversed)
{
  const Index count = static_cast<Index>(triangles.size());
  auto start = [&triangles](Index h) { return triangles[h / 3][h % 3]; };
  std::vector<signed char> turn(count, -1); // 0: keep, 1: turn over
  Indices stack;
  for (Index seed = 0; seed < count; ++seed)
  {
    if (turn[seed] != -1)
    {
      continue;
    }
    Indices component;
    turn[seed] = 0;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const Index t = stack.back();
      stack.pop_back();
      component.push_back(t);
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Index other = partner[h];
        if (other == none)
        {
          continue;
        }
        // Consistent neighbours run along their common edge in opposite directions.
        const signed char wanted = start(h) == start(other) ? 1 - turn[t] : turn[t];
        if (turn[other / 3] == -1)
        {
          turn[other / 3] = wanted;
          stack.push_back(other / 3);
        }
        else if (turn[other / 3] != wanted)
        {
          return { std::min(t, other / 3), std::max(t, other / 3) };
        }
      }
    }
    const auto turned =
      std::count_if(component.begin(), component.end(), [&turn](Index t) { return turn[t] == 1; });
    const signed char minority = 2 * turned > static_cast<std::ptrdiff_t>(component.size()) ? 0 : 1;
    for (Index t : component)
    {
      if (turn[t] == minority)
      {
        std::swap(triangles[t][1], triangles[t][2]);
        reversed.push_back(t);
      }
    }
  }
  std::sort(reversed.begin(), reversed.end());
  return {};
}

/// Pairs the half-edges of any triangles and turns over those that run against the majority of
/// their component.
/// \param pointIds what to call each vertex in messages. \param partner of each half-edge, before a
/// triangle is turned over. \param reversed the triangles that were, ascending.
/// Errors (ids: triangles): NonManifoldEdge, NotOrientable.
Status orientTriangles(
  const Indices& pointIds, Triangles& triangles, Indices& partner, Indices& reversed)
{
  const std::vector<HalfedgeKey> sides = sortedSides(triangles, pointIds.size());
  Indices bad = doubledTriangles(triangles, sides);
  if (!bad.empty())
  {
    return { StatusCode::NonManifoldEdge,
      "triangles " + listIds(bad) + " have the same three corners as another",
      { ElementKind::Cells, bad }, { Remedy::RemoveDoubles, Remedy::SeparateSides } };
  }
  const std::vector<Indices> crowded = crowdedEdges(sides);
  if (!crowded.empty())
  {
    for (const Index h : crowded.front())
    {
      bad.push_back(h / 3);
    }
    const Triangle& t = triangles[bad.front()];
    const Index k = crowded.front().front() % 3;
    const auto [low, high] = std::minmax({ t[k], t[(k + 1) % 3] });
    return crowdedEdge(pointIds[low], pointIds[high], bad);
  }
  partner = pairSides(sides);
  const Indices oneSided = turnOver(triangles, partner, reversed);
  if (!oneSided.empty())
  {
    return { StatusCode::NotOrientable,
      "the surface is one-sided (a Moebius band): triangles " + listIds(oneSided) +
        " cannot be oriented alike",
      { ElementKind::Cells, oneSided }, { Remedy::CutBandThrough } };
  }
  return {};
}

PreparedSurface refuse(Status status)
{
  PreparedSurface result;
  result.status = std::move(status);
  return result;
}

ElementIds triangleIds(const Indices& ids)
{
  return { ElementKind::Cells, ids };
}

/// Per point the first point with the same coordinates; the point itself where they are kept apart.
Indices findCoincident(const Points3& points, CoincidentPoints coincident)
{
  Indices order(points.size());
  std::iota(order.begin(), order.end(), 0);
  if (coincident == CoincidentPoints::Keep)
  {
    return order;
  }
  auto less = [&points](Index i, Index j) {
    const Point3& a = points[i];
    const Point3& b = points[j];
    return a.x() != b.x() ? a.x() < b.x()
      : a.y() != b.y()    ? a.y() < b.y()
      : a.z() != b.z()    ? a.z() < b.z()
                          : i < j;
  };
  std::sort(order.begin(), order.end(), less);
  Indices first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool same = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// Vertices whose triangles form more than one fan.
Indices findBowTies(const TriangleMesh& mesh)
{
  Indices corners(mesh.vertexCount(), 0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    ++corners[mesh.from(h)];
  }
  Indices bowTies;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const VertexFan fan(mesh, v);
    Index seen = 0;
    for (auto h = fan.begin(); h != fan.end(); ++h)
    {
      ++seen;
    }
    if (seen != corners[v])
    {
      bowTies.push_back(v);
    }
  }
  return bowTies;
}

/// Points are joined where hardly any two triangles share one, so that they hang together by
/// coordinates only.
CoincidentPoints resolved(
  CoincidentPoints coincident, const Indices& used, const Triangles& triangles)
{
  const bool soup = triangles.size() > 1 && used.size() >= 2 * triangles.size();
  return coincident != CoincidentPoints::Automatic ? coincident
    : soup                                         ? CoincidentPoints::Join
                                                   : CoincidentPoints::Keep;
}

/// Triangles with a corner outside 0 .. pointCount - 1.
Indices findStrayCorners(const Triangles& triangles, Index pointCount)
{
  Indices bad;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& c = triangles[t];
    if (std::any_of(c.begin(), c.end(), [pointCount](Index p) { return p < 0 || p >= pointCount; }))
    {
      bad.push_back(static_cast<Index>(t));
    }
  }
  return bad;
}

Indices usedPoints(const Triangles& triangles, std::size_t pointCount)
{
  std::vector<char> used(pointCount, 0);
  for (const Triangle& c : triangles)
  {
    used[c[0]] = used[c[1]] = used[c[2]] = 1;
  }
  Indices points;
  points.reserve(pointCount);
  for (std::size_t p = 0; p < pointCount; ++p)
  {
    if (used[p])
    {
      points.push_back(static_cast<Index>(p));
    }
  }
  return points;
}

/// As firstInPlace(), of points that triangles use.
Indices firstAmong(const Points3& points, const Indices& used, CoincidentPoints coincident)
{
  Points3 candidates;
  candidates.reserve(used.size());
  for (Index p : used)
  {
    candidates.push_back(points[p]);
  }
  const Indices among = findCoincident(candidates, coincident);
  Indices first(points.size());
  std::iota(first.begin(), first.end(), 0);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    first[used[i]] = used[among[i]];
  }
  return first;
}

/// Makes vertices of the points, one of all that coincide, and fills in which is which.
Points3 joinPoints(
  const Points3& points, const Indices& used, const Indices& first, PreparedSurface& result)
{
  result.vertexOfPoint.assign(points.size(), none);
  Points3 joined;
  joined.reserve(used.size());
  result.originalPoint.reserve(used.size());
  for (const Index p : used)
  {
    if (first[p] == p)
    {
      result.vertexOfPoint[p] = static_cast<Index>(joined.size());
      result.originalPoint.push_back(p);
      joined.push_back(points[p]);
    }
    else
    {
      result.vertexOfPoint[p] = result.vertexOfPoint[first[p]];
    }
  }
  return joined;
}

/// The triangles between vertices, and which of them have no area.
Triangles renumbered(const Triangles& triangles, const Indices& vertexOfPoint,
  const Points3& vertices, Indices& degenerate)
{
  Triangles cells(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      cells[t][k] = vertexOfPoint[triangles[t][k]];
    }
    if (repeatsCorner(cells[t]) || hasNoArea(vertices, cells[t]))
    {
      degenerate.push_back(static_cast<Index>(t));
    }
  }
  return cells;
}

PreparedSurface prepare(
  const Points3& points, const Triangles& triangles, CoincidentPoints coincidentPoints)
{
  if (triangles.empty())
  {
    return refuse(
      { StatusCode::EmptySurface, "the surface has no triangles", {}, { Remedy::GiveTriangles } });
  }
  const Index pointCount = static_cast<Index>(points.size());
  Indices bad = findStrayCorners(triangles, pointCount);
  if (!bad.empty())
  {
    return refuse({ StatusCode::InvalidPointId,
      "triangles " + listIds(bad) + " use a point id outside 0.." + std::to_string(pointCount - 1),
      triangleIds(bad), { Remedy::WriteAgain } });
  }
  const Indices used = usedPoints(triangles, points.size());
  std::copy_if(used.begin(), used.end(), std::back_inserter(bad),
    [&points](Index p) { return !isUsable(points[p]); });
  if (!bad.empty())
  {
    return refuse({ StatusCode::NonFinitePoint,
      "points " + listIds(bad) + " have a coordinate that is not a finite number, or beyond 1e60",
      { ElementKind::Points, bad }, { Remedy::MendPoints } });
  }
  PreparedSurface result;
  const Indices first = firstAmong(points, used, resolved(coincidentPoints, used, triangles));
  Points3 joined = joinPoints(points, used, first, result);
  Triangles cells = renumbered(triangles, result.vertexOfPoint, joined, bad);
  if (!bad.empty())
  {
    return refuse({ StatusCode::DegenerateTriangle,
      "triangles " + listIds(bad) +
        " have no area (two corners in one place, or three in a line; less than 1e-60 is nothing)",
      triangleIds(bad), { Remedy::RemeshTriangles } });
  }

  Indices partner = pairOrientedSides(cells, joined.size());
  if (partner.empty())
  {
    Status status = orientTriangles(result.originalPoint, cells, partner, result.reversedTriangles);
    if (!status.ok())
    {
      return refuse(std::move(status));
    }
  }
  // Half-edges of a triangle that was turned over have new numbers.
  result.mesh = result.reversedTriangles.empty()
    ? TriangleMesh(std::move(joined), std::move(cells), std::move(partner))
    : TriangleMesh(std::move(joined), std::move(cells));
  for (Index v : findBowTies(result.mesh))
  {
    bad.push_back(result.originalPoint[v]);
  }
  if (!bad.empty())
  {
    return refuse({ StatusCode::NonManifoldVertex,
      "at points " + listIds(bad) + " parts of the surface touch in a single point",
      { ElementKind::Points, bad }, { Remedy::DoublePoint, Remedy::JoinByEdge } });
  }
  return result;
}
}

Indices doubledTriangles(const Triangles& triangles, const std::vector<HalfedgeKey>& sides)
{
  Indices doubled;
  std::vector<std::pair<Index, Index>> around; // corner opposite to an edge, triangle
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const HalfedgeKey& side = sides[i];
    const bool first = i == 0 || sides[i - 1].low != side.low || sides[i - 1].high != side.high;
    if (first)
    {
      around.clear();
    }
    const Index t = side.halfedge / 3;
    around.emplace_back(triangles[t][(side.halfedge + 2) % 3], t);
    const bool last =
      i + 1 == sides.size() || sides[i + 1].low != side.low || sides[i + 1].high != side.high;
    if (last && around.size() > 1)
    {
      std::sort(around.begin(), around.end());
      for (std::size_t k = 1; k < around.size(); ++k)
      {
        if (around[k].first == around[k - 1].first)
        {
          doubled.push_back(around[k].second);
        }
      }
    }
  }
  sortUnique(doubled);
  return doubled;
}

bool hasNoArea(const Points3& points, const Triangle& t)
{
  const Point3& a = points[t[0]];
  const Point3& b = points[t[1]];
  const Point3& c = points[t[2]];
  const double longestSquare =
    std::max({ (b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm() });
  const double crossSquare = (b - a).cross(c - a).squaredNorm();
  // Most triangles are far from it, and from where squares underflow.
  if (longestSquare > 1e-100 && crossSquare > 1e-20 * longestSquare * longestSquare)
  {
    return false;
  }
  // Scaled by the largest difference, so that no product over- or underflows.
  const double size = std::max({ (b - a).cwiseAbs().maxCoeff(), (c - a).cwiseAbs().maxCoeff(),
    (c - b).cwiseAbs().maxCoeff() });
  if (size < 1.0 / largestCoordinate)
  {
    return true;
  }
  const Point3 u = (b - a) / size;
  const Point3 v = (c - a) / size;
  const double longest = std::max({ u.norm(), v.norm(), (u - v).norm() });
  return !(u.cross(v).norm() > flatTriangle * longest * longest);
}

Status crowdedEdge(Index low, Index high, const Indices& triangles)
{
  return { StatusCode::NonManifoldEdge,
    "the edge between points " + std::to_string(low) + " and " + std::to_string(high) +
      " belongs to triangles " + listIds(triangles) + " (an edge can join two at most)",
    triangleIds(triangles), { Remedy::RemoveDoubles, Remedy::SeparateSheets } };
}

Indices firstInPlace(const Points3& points, const Triangles& triangles, CoincidentPoints coincident)
{
  const Indices used = usedPoints(triangles, points.size());
  return firstAmong(points, used, resolved(coincident, used, triangles));
}

PreparedSurface prepareSurface(
  const Points3& points, const Triangles& triangles, CoincidentPoints coincidentPoints)
{
  return withinMemory([&] { return prepare(points, triangles, coincidentPoints); });
}
}
