// SPDX-License-Identifier: BSD-3-Clause
#include "HostileSurface.h"

#include "../Core/MeshTriangles.h"

#include <algorithm>
#include <cmath>

namespace hostile
{
namespace
{
Specimen oneTriangle(std::mt19937& random)
{
  const double height = std::pow(10.0, between(random, -4.0, 1.0));
  return { "one triangle", { { 0, 0, 0 }, { 1, 0, 0 }, { between(random, -1, 2), height, 0.3 } },
    { { 0, 1, 2 } }, {} };
}

/// Parallels and meridians between two poles.
Specimen ball(std::mt19937& random, Index meridians, Index parallels)
{
  Specimen surface;
  surface.name = "ball";
  const Point3 axes(1.0, between(random, 0.3, 2.0), between(random, 0.3, 2.0));
  surface.points = { { 0, 0, axes.z() } };
  for (Index j = 1; j <= parallels; ++j)
  {
    const double polar = pi * j / (parallels + 1);
    for (Index i = 0; i < meridians; ++i)
    {
      const double turn = 2.0 * pi * i / meridians;
      surface.points.push_back(axes.cwiseProduct(Point3(
        std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar))));
    }
  }
  const auto pole = static_cast<Index>(surface.points.size());
  surface.points.push_back({ 0, 0, -axes.z() });
  surface.triangles = testmeshes::ringTriangles(meridians, parallels, meridians);
  const Index last = pole - meridians;
  for (Index i = 0; i < meridians; ++i)
  {
    surface.triangles.push_back({ pole, last + (i + 1) % meridians, last + i });
  }
  return surface;
}

Specimen octahedron()
{
  return { "octahedron",
    { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
      { 0, 3, 5 } },
    {} };
}

Specimen tetrahedron()
{
  return { "tetrahedron", { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } },
    { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 } }, {} };
}

Specimen box(std::mt19937& random)
{
  const Point3 size(1.0, between(random, 0.2, 3.0), between(random, 0.05, 1.0));
  Points3 points;
  for (int k = 0; k < 8; ++k)
  {
    points.push_back(size.cwiseProduct(Point3(k & 1, (k >> 1) & 1, (k >> 2) & 1)));
  }
  return { "box", std::move(points),
    { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 }, { 2, 6, 7 },
      { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } },
    {} };
}

/// Columns of a grid closed to rings, and its rows as well for a torus.
Specimen tube(std::mt19937& random, Index columns, Index rows, bool closed)
{
  Specimen surface;
  surface.name = closed ? "torus" : "tube";
  const double thin = between(random, 0.05, 0.9);
  const double wave = anyOf(random, 0, 2) == 0 ? 0.0 : between(random, 0.0, 0.5);
  const Index rings = closed ? rows : rows + 1;
  for (Index j = 0; j < rings; ++j)
  {
    for (Index i = 0; i < columns; ++i)
    {
      const double u = 2.0 * pi * i / columns;
      const double v = 2.0 * pi * j / rows;
      const double r = closed ? 1.0 + thin * std::cos(v) : 1.0 + wave * std::cos(v);
      surface.points.push_back(
        { r * std::cos(u), r * std::sin(u), closed ? thin * std::sin(v) : 0.5 * thin * v });
    }
  }
  for (Index j = 0; j < rows; ++j)
  {
    for (Index i = 0; i < columns; ++i)
    {
      const Index a = j * columns + i;
      const Index b = j * columns + (i + 1) % columns;
      const Index up = (j + 1) % rings * columns;
      surface.triangles.push_back({ a, b, up + (i + 1) % columns });
      surface.triangles.push_back({ a, up + (i + 1) % columns, up + i });
    }
  }
  return surface;
}

/// A long closed body with slivers along it.
Specimen needle(std::mt19937& random)
{
  Specimen surface = ball(random, anyOf(random, 3, 6), anyOf(random, 2, 10));
  surface.name = "needle";
  for (Point3& point : surface.points)
  {
    point.z() *= 200.0;
  }
  return surface;
}

/// Edges are halved, and what is new is moved onto the unit sphere.
Specimen round(Specimen surface, int times)
{
  surface.name += ", rounded";
  for (Point3& point : surface.points)
  {
    point.normalize();
  }
  for (int k = 0; k < times; ++k)
  {
    const std::size_t old = surface.points.size();
    refineSurface(surface);
    std::for_each(surface.points.begin() + static_cast<std::ptrdiff_t>(old), surface.points.end(),
      [](Point3& point) { point.normalize(); });
  }
  return surface;
}

Specimen shapeOf(std::mt19937& random)
{
  switch (anyOf(random, 0, 13))
  {
    case 0:
      return oneTriangle(random);
    case 1:
      return ball(random, anyOf(random, 3, 20), anyOf(random, 1, 12));
    case 2:
      return tetrahedron();
    case 3:
      return octahedron();
    case 4:
      return box(random);
    case 5:
      return tube(random, anyOf(random, 3, 20), anyOf(random, 3, 14), true);
    case 6:
      return tube(random, anyOf(random, 3, 20), anyOf(random, 1, 14), false);
    case 7:
      return ball(random, anyOf(random, 3, 200), 1); // two hubs over a ring
    case 8:
      return needle(random);
    case 9:
      return round(anyOf(random, 0, 1) == 0 ? octahedron() : tetrahedron(), anyOf(random, 1, 3));
    default:
    {
      const std::vector<std::uint8_t> values = randomBytes(random, 200);
      Bytes bytes(values);
      return makeOrdinarySurface(bytes, { 1.0, 600.0 });
    }
  }
}
}

Specimen makeVariedSurface(std::mt19937& random)
{
  Specimen surface = shapeOf(random);
  if (anyOf(random, 0, 4) == 0)
  {
    const Specimen other = shapeOf(random);
    surface.name += " and " + other.name;
    const auto first = static_cast<Index>(surface.points.size());
    for (const Point3& point : other.points)
    {
      surface.points.emplace_back(point + Point3(0.0, 0.0, 5.0));
    }
    for (const Triangle& t : other.triangles)
    {
      surface.triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    }
  }
  if (anyOf(random, 0, 2) == 0)
  {
    const double unit = std::pow(10.0, anyOf(random, -6, 6));
    for (Point3& point : surface.points)
    {
      point *= unit;
    }
  }
  return surface;
}
}
