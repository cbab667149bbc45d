// SPDX-License-Identifier: BSD-3-Clause
#include "HostileSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace hostile
{
namespace
{
/// The triangles next to a first one, as many as asked for, over the points that they use.
Specimen cropped(const Specimen& whole, Index first, Index count)
{
  std::vector<Indices> trianglesOfPoint(whole.points.size());
  for (std::size_t t = 0; t < whole.triangles.size(); ++t)
  {
    for (const Index v : whole.triangles[t])
    {
      trianglesOfPoint[v].push_back(static_cast<Index>(t));
    }
  }
  Indices taken{ first };
  std::vector<char> seen(whole.triangles.size(), 0);
  seen[first] = 1;
  for (std::size_t k = 0; k < taken.size() && static_cast<Index>(taken.size()) < count; ++k)
  {
    for (const Index v : whole.triangles[taken[k]])
    {
      for (const Index t : trianglesOfPoint[v])
      {
        if (!seen[t] && static_cast<Index>(taken.size()) < count)
        {
          seen[t] = 1;
          taken.push_back(t);
        }
      }
    }
  }
  Specimen part{ whole.name, whole.points, {}, {} };
  for (const Index t : taken)
  {
    part.triangles.push_back(whole.triangles[t]);
  }
  keepUsedPoints(part);
  return part;
}

enum class Shape
{
  Sheet,
  Cushion,
  Tube,
  Sphere,
  Torus,
  Moebius,
  Saddle,
  Count
};

Point3 placeOf(Shape shape, double u, double v, double height)
{
  const double a = 2.0 * pi * u;
  const double b = pi * (v - 0.5);
  const double c = 2.0 * pi * v;
  switch (shape)
  {
    case Shape::Cushion:
      return { u, v, height * std::sin(pi * u) * std::sin(pi * v) };
    case Shape::Tube:
      return { std::cos(a), std::sin(a), 2.0 * v };
    case Shape::Sphere:
      return { std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b) };
    case Shape::Torus:
      return { (2.0 + std::cos(c)) * std::cos(a), (2.0 + std::cos(c)) * std::sin(a), std::sin(c) };
    case Shape::Moebius:
    {
      const double w = v - 0.5;
      return { (1.0 + w * std::cos(a / 2.0)) * std::cos(a),
        (1.0 + w * std::cos(a / 2.0)) * std::sin(a), w * std::sin(a / 2.0) };
    }
    case Shape::Saddle:
      return { u, v, height * (u - 0.5) * (v - 0.5) * 4.0 };
    default:
      return { u, v, 0.0 };
  }
}

/// A grid of the unit square under a map; where the shape closes, points coincide.
Specimen shaped(Shape shape, Index columns, Index rows, double height)
{
  Specimen surface;
  surface.name = "shape " + std::to_string(static_cast<int>(shape));
  const bool closesU = shape >= Shape::Tube && shape <= Shape::Moebius;
  const bool closesV = shape == Shape::Torus;
  const Index wide = closesU ? columns : columns + 1;
  const Index high = closesV ? rows : rows + 1;
  for (Index j = 0; j < high; ++j)
  {
    for (Index i = 0; i < wide; ++i)
    {
      surface.points.push_back(
        placeOf(shape, static_cast<double>(i) / columns, static_cast<double>(j) / rows, height));
    }
  }
  const auto id = [&](Index i, Index j) {
    if (closesU && i == columns)
    {
      i = 0;
      j = shape == Shape::Moebius ? rows - j : j;
    }
    if (shape == Shape::Sphere && (j == 0 || j == rows))
    {
      i = 0;
    }
    return (closesV ? j % rows : j) * wide + i;
  };
  for (Index j = 0; j < rows; ++j)
  {
    for (Index i = 0; i < columns; ++i)
    {
      for (const Triangle& t : { Triangle{ id(i, j), id(i + 1, j), id(i + 1, j + 1) },
             Triangle{ id(i, j), id(i + 1, j + 1), id(i, j + 1) } })
      {
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        {
          surface.triangles.push_back(t);
        }
      }
    }
  }
  return surface;
}

Specimen arbitraryTriangles(Bytes& bytes)
{
  Specimen surface;
  surface.name = "arbitrary triangles";
  const Index points = 3 + bytes.below(6);
  const Index triangles = 1 + bytes.below(8);
  for (Index v = 0; v < points; ++v)
  {
    const double x = bytes.next() % 5;
    const double y = bytes.next() % 5;
    surface.points.push_back({ x, y, static_cast<double>(bytes.next() % 3) });
  }
  for (Index t = 0; t < triangles; ++t)
  {
    const Index a = bytes.below(points);
    const Index b = bytes.below(points);
    surface.triangles.push_back({ a, b, bytes.below(points) });
  }
  return surface;
}

double meanEdge(const Specimen& surface)
{
  double sum = 0.0;
  for (const Triangle& t : surface.triangles)
  {
    sum += (surface.points[t[1]] - surface.points[t[0]]).norm();
  }
  return surface.triangles.empty() ? 1.0 : sum / static_cast<double>(surface.triangles.size());
}

Index anyTriangle(Bytes& bytes, const Specimen& surface)
{
  return bytes.below(static_cast<Index>(surface.triangles.size()));
}

Index anyPoint(Bytes& bytes, const Specimen& surface)
{
  return bytes.below(static_cast<Index>(surface.points.size()));
}

/// Changes the points of a surface and of its curves.
template <class Change>
void forPoints(Specimen& surface, const Change& change)
{
  std::for_each(surface.points.begin(), surface.points.end(), change);
  for (Polyline& curve : surface.curves)
  {
    std::for_each(curve.points.begin(), curve.points.end(), change);
  }
}

void jitter(Bytes& bytes, Specimen& surface, double size)
{
  std::mt19937 random = bytes.generator();
  std::uniform_real_distribution<double> within(-size, size);
  for (Point3& p : surface.points)
  {
    for (Index k = 0; k < 3; ++k)
    {
      p[k] += within(random);
    }
  }
}

/// Moves one corner of a triangle almost onto the next, or almost onto the edge between the others.
void makeSliver(Bytes& bytes, Specimen& surface)
{
  const Triangle t = surface.triangles[anyTriangle(bytes, surface)];
  const double near = std::pow(10.0, -static_cast<double>(1 + bytes.next() % 15));
  const Point3 target = bytes.oneIn(2)
    ? surface.points[t[1]]
    : Point3(0.5 * (surface.points[t[1]] + surface.points[t[2]]));
  surface.points[t[0]] = target + near * (surface.points[t[0]] - target);
}

/// Makes one point of two.
void mergePoints(Bytes& bytes, Specimen& surface)
{
  const Index a = anyPoint(bytes, surface);
  const Index b = anyPoint(bytes, surface);
  for (Triangle& t : surface.triangles)
  {
    std::replace(t.begin(), t.end(), b, a);
  }
}

void breakPoint(Bytes& bytes, Specimen& surface)
{
  const double values[] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), 1e308, -1e300, 1e-310 };
  surface.points[anyPoint(bytes, surface)][bytes.below(3)] = values[bytes.next() % 5];
}

void breakTriangle(Bytes& bytes, Specimen& surface)
{
  const Index values[] = { -1, std::numeric_limits<Index>::max(), std::numeric_limits<Index>::min(),
    static_cast<Index>(surface.points.size()) };
  surface.triangles[anyTriangle(bytes, surface)][bytes.below(3)] = values[bytes.next() % 4];
}

void mutateOnce(Bytes& bytes, Specimen& surface)
{
  switch (bytes.next() % 14)
  {
    case 0:
    case 1:
    case 2:
      surface.triangles.erase(surface.triangles.begin() + anyTriangle(bytes, surface));
      break;
    case 3:
      surface.triangles.push_back(surface.triangles[anyTriangle(bytes, surface)]);
      break;
    case 4:
    case 5:
    {
      Triangle& t = surface.triangles[anyTriangle(bytes, surface)];
      std::swap(t[0], t[1]);
      break;
    }
    case 6:
      mergePoints(bytes, surface);
      break;
    case 7:
    case 8:
      makeSliver(bytes, surface);
      break;
    case 9:
    case 10:
    case 11:
      jitter(bytes, surface,
        meanEdge(surface) * std::pow(10.0, -0.25 * static_cast<double>(2 + bytes.next() % 20)));
      break;
    case 12: // a spike
      surface.points[anyPoint(bytes, surface)] *= 1.0 + 4.0 * bytes.unit();
      break;
    default: // two points in one place
      surface.points[anyPoint(bytes, surface)] = surface.points[anyPoint(bytes, surface)];
      break;
  }
}
}

void keepUsedPoints(Specimen& surface)
{
  Indices number(surface.points.size(), none);
  Points3 used;
  for (Triangle& t : surface.triangles)
  {
    for (Index& v : t)
    {
      if (number[v] == none)
      {
        number[v] = static_cast<Index>(used.size());
        used.push_back(surface.points[v]);
      }
      v = number[v];
    }
  }
  surface.points = std::move(used);
}

Specimen makeSurface(
  Bytes& bytes, const std::vector<Specimen>& specimens, const SizeRange& triangles)
{
  const unsigned kind = bytes.next() % 16;
  // As many small ones as large ones.
  const double share = bytes.unit();
  const auto count =
    static_cast<Index>(triangles.least * std::pow(triangles.most / triangles.least, share));
  if (kind == 0)
  {
    return arbitraryTriangles(bytes);
  }
  if (kind < 5 || specimens.empty())
  {
    const auto shape = static_cast<Shape>(bytes.next() % static_cast<unsigned>(Shape::Count));
    const Index columns = 3 + bytes.below(1 + static_cast<Index>(std::sqrt(count)));
    const Index rows = 2 + bytes.below(std::max<Index>(1, count / (2 * columns)));
    return shaped(shape, columns, rows, bytes.unit());
  }
  const Specimen& whole = specimens[bytes.below(static_cast<Index>(specimens.size()))];
  const Index total = static_cast<Index>(whole.triangles.size());
  if (count >= total)
  {
    Specimen surface = whole;
    while (4 * surface.triangles.size() <= static_cast<std::size_t>(count))
    {
      refineSurface(surface);
    }
    return surface;
  }
  return cropped(whole, bytes.below(total), count);
}

void mutateSurface(Bytes& bytes, Specimen& surface)
{
  // Mostly none or one: what is refused goes no farther.
  const unsigned counts[] = { 0, 0, 0, 1, 1, 1, 2, 5 };
  const unsigned count = counts[bytes.next() % 8];
  for (unsigned k = 0; k < count && !surface.triangles.empty(); ++k)
  {
    mutateOnce(bytes, surface);
  }
  if (!bytes.oneIn(3))
  {
    const double scale = std::pow(10.0, static_cast<double>(bytes.below(19)) - 9.0);
    forPoints(surface, [=](Point3& p) { p *= scale; });
  }
  if (bytes.oneIn(8))
  {
    // Far from the origin.
    const Point3 away = meanEdge(surface) * 1e4 * Point3(1.0, -2.0, 0.5);
    forPoints(surface, [&](Point3& p) { p += away; });
  }
  // Last, because what comes before computes with ids and coordinates.
  if (bytes.oneIn(64) && !surface.triangles.empty())
  {
    breakPoint(bytes, surface);
  }
  if (bytes.oneIn(64) && !surface.triangles.empty())
  {
    breakTriangle(bytes, surface);
  }
}

void refineSurface(Specimen& surface)
{
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [entry, added] =
      middles.insert({ std::minmax(a, b), static_cast<Index>(surface.points.size()) });
    if (added)
    {
      const Point3 between = 0.5 * (surface.points[a] + surface.points[b]);
      surface.points.push_back(between);
    }
    return entry->second;
  };
  Triangles finer;
  for (const auto& [a, b, c] : surface.triangles)
  {
    const Index ab = middle(a, b);
    const Index bc = middle(b, c);
    const Index ca = middle(c, a);
    finer.insert(finer.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
  }
  surface.triangles = std::move(finer);
}
}
