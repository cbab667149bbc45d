// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SheetSides.h"

#include "Base/CompressedRows.h"
#include "Surface/SurfaceLocator.h"
#include "Surface/SurfacePoint.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace flattening
{
namespace
{
/// Thicker parts, in roots of their area, are solid: a ball has 0.19.
constexpr double maxThickness = 0.06;
/// Least share of the area that the two sides have, and least area of the inner over the outer one.
/// Of 18 public double walls (clothes, helmets, lampshades, a hull) the two have 0.78 and more, and
/// the inner one 0.82; of solids that bend as much, 0.67 and less, or an inner side of 0.42.
constexpr double minSides = 0.72;
constexpr double minInner = 0.7;
/// Clear sheets are thinner than this, and than this share of how much they bend: clothes, helmets
/// and a hull have up to 0.024, and 0.04 of the bend; surfboards 0.025 and more, and four times it.
constexpr double clearThickness = 0.03;
constexpr double clearShare = 0.1;
/// Of the border of a side, the share at which the other side may begin without a rim between them:
/// two layers of cloth that are sewn together at their edges are no thick sheet.
constexpr double maxKnife = 0.1;
/// Cosine of the most that the other side's normal, and the way there, turn from a triangle's.
constexpr double minOpposite = 0.8;
/// In mean thicknesses, how far the other side may be.
constexpr double farthestOpposite = 3.0;
/// Cosine of the angle between triangles at which one side ends where there is no rim.
constexpr double foldCosine = -0.5;

/// The triangles of each part without a boundary.
std::vector<Indices> closedParts(const TriangleMesh& mesh)
{
  Indices part;
  std::vector<Indices> closed(connectedParts(mesh, {}, part));
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    closed[part[t]].push_back(t);
  }
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) == none)
    {
      closed[part[h / 3]].clear();
    }
  }
  eraseIf(closed, [](const Indices& triangles) { return triangles.empty(); });
  return closed;
}

/// The part of a mesh that some triangles are.
TriangleMesh partOf(const TriangleMesh& mesh, const Indices& triangles)
{
  std::map<Index, Index> number;
  Points3 points;
  Triangles cells;
  for (Index t : triangles)
  {
    Triangle cell;
    for (int k = 0; k < 3; ++k)
    {
      const Index v = mesh.triangle(t)[k];
      const auto [entry, isNew] = number.emplace(v, static_cast<Index>(points.size()));
      if (isNew)
      {
        points.push_back(mesh.point(v));
      }
      cell[k] = entry->second;
    }
    cells.push_back(cell);
  }
  return TriangleMesh(std::move(points), std::move(cells));
}

double signedVolume(const TriangleMesh& mesh)
{
  double sum = 0.0;
  const Point3& origin = mesh.point(mesh.triangle(0)[0]);
  for (const Triangle& t : mesh.triangles())
  {
    sum +=
      (mesh.point(t[0]) - origin).dot((mesh.point(t[1]) - origin).cross(mesh.point(t[2]) - origin));
  }
  return sum / 6.0;
}

/// Per triangle whether another one is opposite.
std::vector<char> wallsOf(const TriangleMesh& part, double outwards, double thickness)
{
  const SurfaceLocator locator(part);
  std::vector<char> wall(part.triangleCount(), 0);
  for (Index t = 0; t < part.triangleCount(); ++t)
  {
    const Point3 center = part.centroid(t);
    const Point3 normal = outwards * triangleNormal(part, t);
    const ClosestPoint closest = locator.closest(center - thickness * normal);
    const Point3 way = center - closest.position;
    wall[t] = outwards * triangleNormal(part, closest.triangle).dot(normal) < -minOpposite &&
        way.norm() < farthestOpposite * thickness && way.dot(normal) > minOpposite * way.norm()
      ? 1
      : 0;
  }
  return wall;
}

/// Per triangle the number of its side; none in the rim.
Indices sidesOf(const TriangleMesh& part, const std::vector<char>& wall)
{
  JoinedSets sets(part.triangleCount());
  for (Index h = 0; h < part.halfedgeCount(); ++h)
  {
    const Index t = h / 3;
    const Index other = part.twin(h) / 3;
    const bool folded =
      wall[t] && triangleNormal(part, t).dot(triangleNormal(part, other)) < foldCosine;
    if (wall[t] == wall[other] && !folded)
    {
      sets.join(t, other);
    }
  }
  // What lies within one side belongs to it.
  std::map<Index, Index> around; // by part of the rim; none where it is between sides
  for (Index h = 0; h < part.halfedgeCount(); ++h)
  {
    const Index t = h / 3;
    const Index other = part.twin(h) / 3;
    if (!wall[t] && wall[other])
    {
      const Index side = sets.find(other);
      const auto [entry, isNew] = around.emplace(sets.find(t), side);
      entry->second = isNew || entry->second == side ? side : none;
    }
  }
  Indices side(part.triangleCount(), none);
  for (Index t = 0; t < part.triangleCount(); ++t)
  {
    const Index set = sets.find(t);
    const auto within = around.find(set);
    side[t] = wall[t] ? set : within == around.end() ? none : within->second;
  }
  return side;
}
}

std::vector<ThickSheet> thickSheets(const TriangleMesh& mesh)
{
  std::vector<ThickSheet> sheets;
  for (Indices& triangles : closedParts(mesh))
  {
    const TriangleMesh body = partOf(mesh, triangles);
    const double area = body.area();
    const double volume = signedVolume(body);
    ThickSheet sheet;
    sheet.thickness = 2.0 * std::abs(volume) / area;
    if (!(sheet.thickness > 0.0) || sheet.thickness > maxThickness * std::sqrt(area))
    {
      continue;
    }
    const Indices side = sidesOf(body, wallsOf(body, volume > 0.0 ? 1.0 : -1.0, sheet.thickness));
    std::map<Index, double> areas;
    for (Index t = 0; t < body.triangleCount(); ++t)
    {
      areas[side[t]] += body.area(t);
    }
    areas.erase(none);
    areas.emplace(none, 0.0); // where there is no inner side
    const auto smaller = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto [outer, outerArea] = *std::max_element(areas.begin(), areas.end(), smaller);
    areas.erase(outer);
    const auto [inner, innerArea] = areas.empty()
      ? std::pair<const Index, double>(none, 0.0)
      : *std::max_element(areas.begin(), areas.end(), smaller);
    if (outerArea + innerArea < minSides * area || innerArea < minInner * outerArea)
    {
      continue;
    }
    double border = 0.0;
    double knife = 0.0;
    Point3 normals = Point3::Zero();
    for (Index h = 0; h < body.halfedgeCount(); ++h)
    {
      const Index t = h / 3;
      const Index beyond = side[body.twin(h) / 3];
      if (side[t] != outer)
      {
        continue;
      }
      if (h % 3 == 0)
      {
        sheet.outer.push_back(triangles[t]);
        normals += body.area(t) * triangleNormal(body, t);
      }
      border += beyond != outer ? body.length(h) : 0.0;
      knife += beyond == inner ? body.length(h) : 0.0;
    }
    const double bend = 1.0 - normals.norm() / outerArea;
    sheet.isClear = knife <= maxKnife * border &&
      sheet.thickness <= std::sqrt(area) * std::min(clearThickness, clearShare * bend);
    sheet.triangles = std::move(triangles);
    sheets.push_back(std::move(sheet));
  }
  return sheets;
}
}
