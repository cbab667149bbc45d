// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Base/ThreadedLoop.h"
#include "Cut/SurfaceCut.h"
#include "MeshTriangles.h"
#include "Surface/SurfacePreparation.h"
#include "Surface/TriangleMesh.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Surfaces made in code, for the tests of Core. What nearly all of these need is included here.
namespace testmeshes
{
using namespace flattening;

/// A mesh with feature curves and, where the surface is developable, its unrolling.
struct Surface
{
  TriangleMesh mesh;
  std::vector<FeatureCurve> curves;
  Points2 unrolled;
};

inline Surface withCurves(Surface surface, std::vector<FeatureCurve> curves)
{
  surface.curves = std::move(curves);
  return surface;
}

inline FeatureCurve accessory(const std::string& name, Indices vertices)
{
  FeatureCurve curve;
  curve.name = name;
  curve.vertices = std::move(vertices);
  return curve;
}

inline FeatureCurve curveOf(CurveType type, const std::string& name, Indices vertices)
{
  FeatureCurve curve = accessory(name, std::move(vertices));
  curve.type = type;
  return curve;
}

/// Largest distance between corresponding points; infinite where their numbers differ.
template <class Point>
double largestDistance(const std::vector<Point>& a, const std::vector<Point>& b)
{
  double most = a.size() == b.size() ? 0.0 : HUGE_VAL;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    const double distance = (a[i] - b[i]).norm();
    most = std::isnan(distance) ? HUGE_VAL : std::max(most, distance);
  }
  return most;
}

/// The mesh with each vertex where a function of its place puts it.
template <class Place>
TriangleMesh moved(const TriangleMesh& mesh, const Place& place)
{
  Points3 points;
  for (const Point3& p : mesh.points())
  {
    points.push_back(place(p));
  }
  return { std::move(points), mesh.triangles() };
}

/// Vertex (i, j) of a patch().
inline Index at(Index columns, Index i, Index j)
{
  return j * (columns + 1) + i;
}

/// (columns + 1) x (rows + 1) vertices whose places come from two functions of (i, j); the
/// diagonals alternate.
inline Surface patch(Index columns, Index rows, const std::function<Point3(double, double)>& place,
  const std::function<Point2(double, double)>& unroll = {})
{
  Points3 points;
  Surface surface;
  for (Index j = 0; j <= rows; ++j)
  {
    for (Index i = 0; i <= columns; ++i)
    {
      points.push_back(place(i, j));
      if (unroll)
      {
        surface.unrolled.push_back(unroll(i, j));
      }
    }
  }
  Triangles triangles;
  for (Index j = 0; j < rows; ++j)
  {
    for (Index i = 0; i < columns; ++i)
    {
      const Index a = j * (columns + 1) + i;
      const Index b = a + 1;
      const Index c = b + columns + 1;
      const Index d = a + columns + 1;
      if ((i + j) % 2 == 0)
      {
        triangles.push_back({ a, b, c });
        triangles.push_back({ a, c, d });
      }
      else
      {
        triangles.push_back({ a, b, d });
        triangles.push_back({ b, c, d });
      }
    }
  }
  surface.mesh = TriangleMesh(std::move(points), std::move(triangles));
  return surface;
}

/// A height over the square of [-1, 1] x [-1, 1], of n x n cells.
inline Surface heightField(Index n, const std::function<double(double, double)>& height)
{
  return patch(n, n, [&](double i, double j) {
    const double x = 2.0 * i / n - 1.0;
    const double y = 2.0 * j / n - 1.0;
    return Point3(x, y, height(x, y));
  });
}

/// Rings of n vertices around vertex 0, the k-th of ring j is 1 + (j - 1) n + k. Places come from
/// the share of the way to the last ring, and the angle.
inline TriangleMesh disk(Index rings, Index n, const std::function<Point3(double, double)>& place)
{
  Points3 points{ place(0.0, 0.0) };
  for (Index j = 1; j <= rings; ++j)
  {
    for (Index k = 0; k < n; ++k)
    {
      points.push_back(place(static_cast<double>(j) / rings, 2.0 * pi * k / n));
    }
  }
  return { std::move(points), ringTriangles(n, rings, n) };
}

/// A flat sheet of unit squares where z = 0.
inline Surface unitSquares(Index columns, Index rows)
{
  return patch(
    columns, rows, [](double i, double j) { return Point3(i, j, 0.0); },
    [](double i, double j) { return Point2(i, j); });
}

/// A flat rectangle in a slanted plane of space, with uneven triangles.
inline Surface flatPatch(Index columns, Index rows)
{
  const auto flat = [](double i, double j) {
    return Point2(i + 0.2 * std::sin(2.0 * i + j), j + 0.2 * std::sin(i - 3.0 * j));
  };
  const Point3 u = Point3(2.0, 1.0, 2.0) / 3.0;
  const Point3 v = Point3(-1.0, -2.0, 2.0) / 3.0;
  return patch(
    columns, rows,
    [&](double i, double j) -> Point3 {
      return flat(i, j).x() * u + flat(i, j).y() * v + Point3(3.0, -2.0, 1.0);
    },
    flat);
}

/// A doubly curved patch like the shell of a cushion; `height` 0 is flat.
inline Surface cushion(Index columns, Index rows, double height)
{
  return patch(columns, rows, [=](double i, double j) {
    const double x = i / columns;
    const double y = j / columns;
    const double top = std::sin(pi * x) * std::sin(pi * y * columns / rows);
    return Point3(x, y, height * top);
  });
}

/// A sector of a polyhedral cone with its apex left out: planar strips between its rulings, whose
/// unrolling is exact.
inline Surface cone(Index columns, Index rows)
{
  const double inner = 0.4;
  const double outer = 1.5;
  const double half = 0.45;          // angle between axis and ruling
  const double turn = 2.4 / columns; // around the axis, from one ruling to the next
  // angle in space between neighbouring rulings
  const double sinHalf = std::sin(half) * std::sin(0.5 * turn);
  const double angle = 2.0 * std::asin(sinHalf);
  const auto radius = [=](double j) { return inner + (outer - inner) * j / rows; };
  return patch(
    columns, rows,
    [=](double i, double j) {
      // against the unrolling's sense, so that the patch is seen from outside
      return Point3(radius(j) * std::sin(half) * std::cos(-turn * i),
        radius(j) * std::sin(half) * std::sin(-turn * i), radius(j) * std::cos(half));
    },
    [=](double i, double j) {
      return Point2(radius(j) * std::cos(-angle * i), radius(j) * std::sin(-angle * i));
    });
}

/// A part of a polyhedral cylinder, strips of unequal width between its rulings, unrolled exactly.
inline Surface cylinder(Index columns, Index rows)
{
  std::vector<double> turn(columns + 1);
  std::vector<double> along(columns + 1, 0.0);
  for (Index i = 0; i <= columns; ++i)
  {
    turn[i] = 3.0 * i / columns + 0.3 / columns * std::sin(1.7 * i);
    along[i] = i == 0 ? 0.0 : along[i - 1] + 2.0 * std::sin(0.5 * (turn[i] - turn[i - 1]));
  }
  const auto height = [=](double i, double j) {
    return 2.0 * j / rows + 0.1 * std::sin(0.9 * i) * j * (rows - j) / (rows * rows);
  };
  return patch(
    columns, rows,
    [=](double i, double j) {
      const double angle = turn[static_cast<std::size_t>(i)];
      return Point3(std::cos(angle), std::sin(angle), height(i, j));
    },
    [=](double i, double j) { return Point2(along[static_cast<std::size_t>(i)], height(i, j)); });
}

/// The paper's quarter-sphere (Fig. 11): a lune of the unit sphere, 90 degrees wide, of 4 x 8
/// steps, 37 vertices and 56 triangles, with the arc half-way between the poles as the only feature
/// curve.
inline Surface quarterSphere()
{
  Points3 points{ Point3(0.0, 0.0, -1.0) };
  const auto at = [](Index i, Index j) -> Index {
    return j == 0 ? 0 : j == 8 ? 36 : 1 + (j - 1) * 5 + i;
  };
  for (Index j = 1; j < 8; ++j)
  {
    for (Index i = 0; i <= 4; ++i)
    {
      const double longitude = i * pi / 8.0;
      const double latitude = -pi / 2.0 + j * pi / 8.0;
      points.push_back(Point3(std::cos(latitude) * std::cos(longitude),
        std::cos(latitude) * std::sin(longitude), std::sin(latitude)));
    }
  }
  points.push_back(Point3(0.0, 0.0, 1.0));
  Triangles triangles;
  for (Index j = 0; j < 8; ++j)
  {
    for (Index i = 0; i < 4; ++i)
    {
      if (j < 7)
      {
        triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
      }
      if (j > 0)
      {
        triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      }
    }
  }
  Surface surface;
  surface.mesh = TriangleMesh(std::move(points), std::move(triangles));
  surface.curves.push_back(accessory("arc", { at(0, 4), at(1, 4), at(2, 4), at(3, 4), at(4, 4) }));
  return surface;
}

/// A closed ring of n x n quads: vertex i n + j is i around the axis and j around the tube, whose
/// triangles are 2 (i n + j) and the next. \param radius of the ring; that of the tube is 1
inline TriangleMesh torus(Index n, double radius)
{
  Points3 points;
  Triangles triangles;
  for (Index i = 0; i < n; ++i)
  {
    for (Index j = 0; j < n; ++j)
    {
      const double u = 2.0 * pi * i / n;
      const double v = 2.0 * pi * j / n;
      const double r = radius + std::cos(v);
      points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
      const Index a = i * n + j;
      const Index b = (i + 1) % n * n + j;
      const Index c = (i + 1) % n * n + (j + 1) % n;
      const Index d = i * n + (j + 1) % n;
      triangles.push_back({ a, b, c });
      triangles.push_back({ a, c, d });
    }
  }
  return TriangleMesh(std::move(points), std::move(triangles));
}

/// The triangles whose centers are to be kept, without the vertices of no other.
inline PreparedSurface partWhere(
  const TriangleMesh& mesh, const std::function<bool(const Point3&)>& isKept)
{
  Triangles kept;
  for (const Triangle& t : mesh.triangles())
  {
    if (isKept((mesh.point(t[0]) + mesh.point(t[1]) + mesh.point(t[2])) / 3.0))
    {
      kept.push_back(t);
    }
  }
  return prepareSurface(mesh.points(), kept);
}

/// Processor time of a call, in seconds.
template <class Work>
double secondsOf(const Work& work)
{
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The surface turned and moved as a whole.
inline Surface movedRigidly(Surface surface)
{
  const Eigen::AngleAxisd turn(1.2, Point3(1.0, -2.0, 0.5).normalized());
  surface.mesh = moved(
    surface.mesh, [&](const Point3& p) -> Point3 { return turn * p + Point3(3.0, -7.0, 11.0); });
  return surface;
}

/// Surfaces as one, in the order given. Curves keep their order.
inline Surface together(const std::vector<Surface>& parts)
{
  Surface all;
  Points3 points;
  Triangles triangles;
  for (const Surface& part : parts)
  {
    const auto first = static_cast<Index>(points.size());
    points.insert(points.end(), part.mesh.points().begin(), part.mesh.points().end());
    for (Triangle t : part.mesh.triangles())
    {
      triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
    }
    for (FeatureCurve curve : part.curves)
    {
      for (Index& v : curve.vertices)
      {
        v += first;
      }
      all.curves.push_back(curve);
    }
  }
  all.mesh = TriangleMesh(std::move(points), std::move(triangles));
  return all;
}

/// Four sides of a pyramid, with its edges to the top as curves: it cannot be laid flat without a
/// change of their lengths.
inline Surface pyramid(double height)
{
  Points3 points{ Point3(0, 0, height), Point3(1, 0, 0), Point3(0, 1, 0), Point3(-1, 0, 0),
    Point3(0, -1, 0) };
  Surface surface;
  surface.mesh =
    TriangleMesh(std::move(points), { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 1 } });
  for (Index v = 1; v <= 4; ++v)
  {
    surface.curves.push_back(accessory("ridge " + std::to_string(v), { 0, v }));
  }
  return surface;
}

/// Vertices i = 0 .. columns of row j of a patch(), as a curve across it.
inline FeatureCurve rowCurve(Index columns, Index j, CurveType type = CurveType::Accessory)
{
  Indices vertices;
  for (Index i = 0; i <= columns; ++i)
  {
    vertices.push_back(j * (columns + 1) + i);
  }
  return curveOf(type, "row" + std::to_string(j), std::move(vertices));
}

inline FeatureCurve columnCurve(
  Index columns, Index rows, Index i, CurveType type = CurveType::Accessory)
{
  Indices vertices;
  for (Index j = 0; j <= rows; ++j)
  {
    vertices.push_back(j * (columns + 1) + i);
  }
  return curveOf(type, "column" + std::to_string(i), std::move(vertices));
}

/// The part of the unit sphere within an angle of its pole, in rings of triangles of equal size,
/// with wires along diameters, the second across the first.
inline Surface sphereCap(double angle, Index rings, int wires)
{
  const auto at = [](Index ring, Index k) -> Index {
    return ring == 0 ? 0 : 1 + 2 * ring * (ring - 1) + k % (4 * ring);
  };
  Points3 points{ Point3(0.0, 0.0, 1.0) };
  Triangles triangles;
  for (Index ring = 1; ring <= rings; ++ring)
  {
    const double down = angle * ring / rings;
    for (Index k = 0; k < 4 * ring; ++k)
    {
      const double around = 2.0 * pi * k / (4 * ring);
      points.push_back(Point3(
        std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down)));
      const Index quarter = k / ring;
      const Index inner = k - quarter;
      triangles.push_back({ at(ring - 1, inner), at(ring, k), at(ring, k + 1) });
      if (k % ring != ring - 1)
      {
        triangles.push_back({ at(ring - 1, inner), at(ring, k + 1), at(ring - 1, inner + 1) });
      }
    }
  }
  Surface surface;
  surface.mesh = TriangleMesh(std::move(points), std::move(triangles));
  for (Index wire = 0; wire < wires; ++wire)
  {
    Indices vertices{ 0 };
    for (Index ring = 1; ring <= rings; ++ring)
    {
      vertices.insert(vertices.begin(), at(ring, wire * ring));
      vertices.push_back(at(ring, (wire + 2) * ring));
    }
    surface.curves.push_back(accessory("diameter" + std::to_string(wire), std::move(vertices)));
  }
  return surface;
}

inline Execution withThreads(unsigned int count)
{
  Execution execution;
  execution.parallel = ThreadedLoop(count);
  return execution;
}
}
