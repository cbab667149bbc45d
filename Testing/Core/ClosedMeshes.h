// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TestMeshes.h"

#include <map>

/// Surfaces that close on themselves, for the tests of Core.
namespace testmeshes
{
using namespace flattening;

/// A tube, open at both ends, whose places come from the turn, up to 2 pi, and the share of the
/// way along it: vertex (i, j) = j around + i.
template <class Place>
TriangleMesh rolledUp(Index around, Index across, const Place& place)
{
  Points3 points;
  Triangles triangles;
  for (Index j = 0; j <= across; ++j)
  {
    for (Index i = 0; i < around; ++i)
    {
      points.push_back(place(2.0 * pi * i / around, static_cast<double>(j) / across));
      if (j < across)
      {
        const Index a = j * around + i;
        const Index b = j * around + (i + 1) % around;
        triangles.push_back({ a, b, b + around });
        triangles.push_back({ a, b + around, a + around });
      }
    }
  }
  return { std::move(points), std::move(triangles) };
}

/// A tube of this height around the z axis. \param radius at a share of the height
inline TriangleMesh revolved(
  Index around, Index across, double height, const std::function<double(double)>& radius)
{
  return rolledUp(around, across, [&](double turn, double share) {
    const double r = radius(share);
    return Point3(r * std::cos(turn), r * std::sin(turn), height * share);
  });
}
inline TriangleMesh revolved(Index around, Index across, double height, double radius = 1.0)
{
  return revolved(around, across, height, [radius](double) { return radius; });
}

/// Closed at two poles, vertices 0 and 1; the i-th vertex of ring j = 1 .. along - 1 is
/// 2 + (j - 1) around + i. Places come from the turn, and from the angle from the first pole.
inline TriangleMesh betweenPoles(
  Index around, Index along, const std::function<Point3(double, double)>& place)
{
  Points3 points{ place(0.0, 0.0), place(0.0, pi) };
  for (Index j = 1; j < along; ++j)
  {
    for (Index i = 0; i < around; ++i)
    {
      points.push_back(place(2.0 * pi * i / around, pi * j / along));
    }
  }
  const auto vertex = [&](Index i, Index j) { return 2 + (j - 1) * around + i % around; };
  Triangles triangles;
  for (Index i = 0; i < around; ++i)
  {
    triangles.push_back({ 0, vertex(i, 1), vertex(i + 1, 1) });
    triangles.push_back({ 1, vertex(i + 1, along - 1), vertex(i, along - 1) });
    for (Index j = 1; j + 1 < along; ++j)
    {
      triangles.push_back({ vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1) });
      triangles.push_back({ vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j) });
    }
  }
  return { std::move(points), std::move(triangles) };
}

/// Two triangles a side, its corners 0 and 1 in each coordinate.
inline TriangleMesh cube()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
             { 1, 1, 1 }, { 0, 1, 1 } },
    { { 0, 2, 1 }, { 0, 3, 2 }, { 4, 5, 6 }, { 4, 6, 7 }, { 0, 1, 5 }, { 0, 5, 4 }, { 1, 2, 6 },
      { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 }, { 3, 0, 4 }, { 3, 4, 7 } } };
}

/// The unit sphere: an octahedron whose edges are halved again and again.
inline TriangleMesh sphere(int halvings)
{
  Points3 points{ { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  Triangles triangles{ { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  for (int k = 0; k < halvings; ++k)
  {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto found = middles.emplace(std::minmax(a, b), static_cast<Index>(points.size()));
      if (found.second)
      {
        points.emplace_back((points[a] + points[b]).normalized());
      }
      return found.first->second;
    };
    Triangles finer;
    for (const auto& [a, b, c] : triangles)
    {
      const Index x = middle(a, b);
      const Index y = middle(b, c);
      const Index z = middle(c, a);
      finer.insert(finer.end(), { { a, x, z }, { b, y, x }, { c, z, y }, { x, y, z } });
    }
    triangles = finer;
  }
  return { std::move(points), std::move(triangles) };
}

/// A ball with limbs, that is no mirror image of itself.
inline TriangleMesh limbedBall(int halvings, double limbs)
{
  const Points3 directions{ { 1.0, 0.2, 0.1 }, { -0.8, 0.7, 0.1 }, { -0.5, -1.0, 0.3 },
    { 0.2, 0.1, 1.0 }, { 0.3, -0.3, -1.0 } };
  return moved(sphere(halvings), [&](const Point3& p) -> Point3 {
    double radius = 0.5;
    double length = limbs;
    for (const Point3& direction : directions)
    {
      radius += length * std::exp(12.0 * (p.dot(direction.normalized()) - 1.0));
      length *= 0.9;
    }
    return radius * p;
  });
}
}
