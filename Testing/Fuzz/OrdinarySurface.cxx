// SPDX-License-Identifier: BSD-3-Clause
#include "HostileSurface.h"

#include "../Core/MeshTriangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hostile
{
namespace
{
/// As many small counts as large ones.
Index logarithmic(std::mt19937& random, double least, double most)
{
  return static_cast<Index>(
    std::exp(between(random, std::log(least), std::log(std::max(least, most)))));
}

/// Rings around a pole; half a turn puts the pole on the boundary.
Specimen rings(std::mt19937& random, Index count, bool whole)
{
  Specimen surface;
  surface.name = whole ? "dome" : "fan";
  const Index meridians = logarithmic(random, 3.0, std::min(1000.0, double(count)));
  const Index parallels = std::max(1, count / (2 * meridians));
  const double height = anyOf(random, 0, 3) == 0 ? 0.0 : between(random, -2.0, 2.0);
  const double round = between(random, 0.0, 1.5);
  const double turn = whole ? 2.0 * pi : between(random, 0.2, 1.9) * pi;
  const Index columns = whole ? meridians : meridians + 1;
  surface.points.push_back({ 0.0, 0.0, height });
  for (Index j = 1; j <= parallels; ++j)
  {
    for (Index i = 0; i < columns; ++i)
    {
      const double r = static_cast<double>(j) / parallels;
      const double a = turn * i / meridians;
      const double z = height * ((1.0 - r) + round * (std::cos(r) - 1.0 + r));
      surface.points.push_back({ r * std::cos(a), r * std::sin(a), z });
    }
  }
  surface.triangles = testmeshes::ringTriangles(meridians, parallels, columns);
  return surface;
}

/// A row of points between two hubs.
Specimen doubleFan(std::mt19937& random, Index count)
{
  Specimen surface;
  surface.name = "double fan";
  const Index row = std::max(1, count / 2);
  const double sag = between(random, 0.0, 0.6);
  surface.points = { { -between(random, 0.3, 2.0), 0.0, 0.0 }, { 1.0, 0.0, 0.0 } };
  for (Index k = 0; k <= row; ++k)
  {
    const double t = static_cast<double>(k) / row - 0.5;
    surface.points.push_back({ 0.0, t, sag * std::cos(3.0 * t) });
  }
  for (Index k = 0; k < row; ++k)
  {
    surface.triangles.push_back({ 0, k + 2, k + 3 });
    surface.triangles.push_back({ 1, k + 3, k + 2 });
  }
  return surface;
}

/// A zigzag of triangles whose middle runs along a spiral, a stair or a straight line.
Specimen strip(std::mt19937& random, Index count)
{
  Specimen surface;
  surface.name = "strip";
  const double turns = anyOf(random, 0, 2) == 0 ? 0.0 : between(random, 0.2, 6.0);
  const double rise = between(random, 0.0, 1.0);
  const double width = between(random, 0.02, 0.4);
  for (Index k = 0; k < count + 2; ++k)
  {
    const double t = static_cast<double>(k) / (count + 1);
    const double a = 2.0 * pi * turns * t;
    const double r = 1.0 + turns * t + (k % 2 == 0 ? 0.0 : width);
    surface.points.push_back(turns == 0.0
        ? Point3(10.0 * t, k % 2 == 0 ? 0.0 : width, rise * std::sin(4.0 * t))
        : Point3(r * std::cos(a), r * std::sin(a), rise * turns * t));
  }
  for (Index k = 0; k < count; ++k)
  {
    surface.triangles.push_back(
      k % 2 == 0 ? Triangle{ k, k + 1, k + 2 } : Triangle{ k + 1, k, k + 2 });
  }
  return surface;
}

Specimen grid(std::mt19937& random, Index columns, Index rows, double aspect)
{
  Specimen surface;
  surface.name = "grid";
  const double height = between(random, -0.8, 0.8);
  for (Index j = 0; j <= rows; ++j)
  {
    for (Index i = 0; i <= columns; ++i)
    {
      const double u = static_cast<double>(i) / columns;
      const double v = static_cast<double>(j) / rows;
      surface.points.push_back({ aspect * u, v,
        height * std::min(1.0, aspect) * std::sin(3.0 * u + 1.0) * std::cos(2.0 * v) });
    }
  }
  surface.triangles = testmeshes::gridTriangles(columns, rows);
  return surface;
}

/// Teeth on one back, or arms around a middle: columns of a grid taken out.
Specimen comb(std::mt19937& random, Index count)
{
  const Index teeth = std::max(2, std::min(40, count / 12));
  const Index length = std::max(2, count / (4 * teeth));
  Specimen surface = grid(random, 2 * teeth - 1, length, between(random, 0.5, 4.0));
  surface.name = "comb";
  Triangles kept;
  for (Index t = 0; t < static_cast<Index>(surface.triangles.size()); ++t)
  {
    const Index cell = t / 2;
    const Index column = cell % (2 * teeth - 1);
    if (column % 2 == 0 || cell < 2 * teeth - 1)
    {
      kept.push_back(surface.triangles[t]);
    }
  }
  surface.triangles = std::move(kept);
  keepUsedPoints(surface);
  return surface;
}

/// Arms of triangles one wide around a hub.
Specimen star(std::mt19937& random, Index count)
{
  Specimen surface;
  surface.name = "star";
  const Index arms = std::max(3, std::min(logarithmic(random, 3.0, 300.0), count / 3));
  const Index length = std::max(1, count / arms - 1);
  const double height = between(random, -1.0, 1.0);
  surface.points.push_back({ 0.0, 0.0, height });
  for (Index i = 0; i < arms; ++i)
  {
    const double a = 2.0 * pi * i / arms;
    surface.points.push_back({ std::cos(a), std::sin(a), 0.3 * height });
  }
  for (Index i = 0; i < arms; ++i)
  {
    Index left = 1 + i;
    Index right = 1 + (i + 1) % arms;
    surface.triangles.push_back({ 0, left, right });
    if (i % 2 == 1)
    {
      continue; // room between the arms
    }
    for (Index k = 0; k < length; ++k)
    {
      const double a = 2.0 * pi * (i + (k % 2 == 0 ? 0.3 : 0.7)) / arms;
      const double r = 1.3 + 0.3 * k;
      surface.points.push_back({ r * std::cos(a), r * std::sin(a), 0.1 * height / r });
      const auto tip = static_cast<Index>(surface.points.size()) - 1;
      surface.triangles.push_back({ left, tip, right });
      (k % 2 == 0 ? left : right) = tip;
    }
  }
  return surface;
}

/// A point in the middle of some triangles, joined to their corners.
void poke(std::mt19937& random, Specimen& surface, Index times)
{
  for (Index k = 0; k < times; ++k)
  {
    const Index t = anyOf(random, 0, static_cast<Index>(surface.triangles.size()) - 1);
    const Triangle c = surface.triangles[t];
    const Point3 middle =
      (surface.points[c[0]] + surface.points[c[1]] + surface.points[c[2]]) / 3.0;
    const auto v = static_cast<Index>(surface.points.size());
    surface.points.push_back(middle);
    surface.triangles[t] = { c[0], c[1], v };
    surface.triangles.push_back({ c[1], c[2], v });
    surface.triangles.push_back({ c[2], c[0], v });
  }
}

/// Halves the longest edge of the triangle at a place until its edges are shorter by a factor.
void refineAt(std::mt19937& random, Specimen& surface, double factor)
{
  const Index at = anyOf(random, 0, static_cast<Index>(surface.triangles.size()) - 1);
  const auto size = [&](const Triangle& c, int k) {
    return (surface.points[c[(k + 1) % 3]] - surface.points[c[k]]).norm();
  };
  const auto longest = [&](const Triangle& c) {
    const int k = size(c, 1) > size(c, 0) ? 1 : 0;
    return size(c, 2) > size(c, k) ? 2 : k;
  };
  const double goal = size(surface.triangles[at], longest(surface.triangles[at])) / factor;
  for (int round = 0; round < 60; ++round)
  {
    const Triangle c = surface.triangles[at];
    const int k = longest(c);
    if (size(c, k) < goal)
    {
      return;
    }
    const Index a = c[k];
    const Index b = c[(k + 1) % 3];
    const auto middle = static_cast<Index>(surface.points.size());
    const Point3 place = 0.5 * (surface.points[a] + surface.points[b]);
    surface.points.push_back(place);
    const std::size_t count = surface.triangles.size();
    for (std::size_t t = 0; t < count; ++t)
    {
      const Triangle old = surface.triangles[t];
      for (int i = 0; i < 3; ++i)
      {
        if (std::minmax(old[i], old[(i + 1) % 3]) == std::minmax(a, b))
        {
          surface.triangles[t] = { old[i], middle, old[(i + 2) % 3] };
          surface.triangles.push_back({ middle, old[(i + 1) % 3], old[(i + 2) % 3] });
        }
      }
    }
  }
}

void renumber(std::mt19937& random, Specimen& surface)
{
  Indices number(surface.points.size());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  Points3 points(number.size());
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    points[number[v]] = surface.points[v];
  }
  surface.points = std::move(points);
  for (Triangle& t : surface.triangles)
  {
    std::transform(t.begin(), t.end(), t.begin(), [&](Index v) { return number[v]; });
    std::rotate(t.begin(), t.begin() + anyOf(random, 0, 2), t.end());
  }
  std::shuffle(surface.triangles.begin(), surface.triangles.end(), random);
}

Specimen shapeOf(unsigned kind, std::mt19937& random, Index count)
{
  const Index side = std::max(1, static_cast<Index>(std::sqrt(0.5 * count)));
  switch (kind)
  {
    case 0:
    case 1:
      return rings(random, count, true);
    case 2:
    case 3:
      return rings(random, count, false);
    case 4:
      return doubleFan(random, count);
    case 5:
    case 6:
      return strip(random, count);
    case 7:
      return comb(random, count);
    case 8:
      return star(random, count);
    case 9:
    {
      const Index rows = logarithmic(random, 1.0, side);
      const double aspect = std::pow(10.0, between(random, -3.0, 3.0));
      return grid(random, std::max(1, count / (2 * rows)), rows, aspect);
    }
    default:
    {
      // What is poked and refined is round, flat or long.
      Specimen surface = kind % 2 == 0 ? grid(random, side, side, 1.0) : rings(random, count, true);
      if (kind < 14)
      {
        poke(random, surface, anyOf(random, 1, count / 2));
        surface.name += ", poked";
      }
      else
      {
        refineAt(random, surface, std::pow(10.0, between(random, 1.0, 4.0)));
        surface.name += ", refined";
      }
      return surface;
    }
  }
}
}

Specimen makeOrdinarySurface(Bytes& bytes, const SizeRange& triangles)
{
  const unsigned kind = bytes.next() % 16;
  std::mt19937 random = bytes.generator();
  const Index count = std::max(1, logarithmic(random, triangles.least, triangles.most));
  Specimen surface = shapeOf(kind, random, count);
  if (bytes.oneIn(2))
  {
    renumber(random, surface);
    surface.name += ", renumbered";
  }
  return surface;
}
}
