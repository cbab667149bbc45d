// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/PolygonTriangulation.h"

#include "Base/Orientation.h"
#include "Surface/SurfacePreparation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{
/// The coordinate plane in which a polygon appears the largest and anti-clockwise.
struct Projection
{
  int u = 0;
  int v = 1;

  Projection(const Points3& points, const Indices& corners)
  {
    Point3 normal = Point3::Zero();
    const Point3& origin = points[corners[0]];
    for (std::size_t k = 2; k < corners.size(); ++k)
    {
      normal += (points[corners[k - 1]] - origin).cross(points[corners[k]] - origin);
    }
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    this->u = (axis + 1) % 3;
    this->v = (axis + 2) % 3;
    if (normal[axis] < 0.0)
    {
      std::swap(this->u, this->v);
    }
  }
  Point2 operator()(const Point3& x) const { return { x[this->u], x[this->v] }; }
};

double longestSquare(const Point2& a, const Point2& b, const Point2& c)
{
  return std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
}

bool isConvex(const Point2& a, const Point2& b, const Point2& c)
{
  return orientation(a, b, c) > 0 && cross(b - a, c - a) > flatTriangle * longestSquare(a, b, c);
}

bool isBetween(const Point2& p, const Point2& a, const Point2& b)
{
  return orientation(a, b, p) == 0 && p != a && p != b && (p - a).dot(b - p) > 0.0;
}

class EarClipping
{
public:
  EarClipping(const Points3& points, const Indices& corners)
    : Corners(corners)
    , Count(corners.size())
  {
    const Projection project(points, corners);
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      this->At.push_back(project(points[corners[k]]));
      this->Next.push_back((k + 1) % this->Count);
      this->Previous.push_back((k + this->Count - 1) % this->Count);
    }
  }

  Triangles run()
  {
    this->rate();
    std::size_t left = this->Count;
    std::size_t rated = left; // corners when all of them were looked at
    for (; left > 3; --left)
    {
      std::size_t tip = this->best();
      // Other cuts may have made ears; those of a polygon that crosses itself are looked for
      // rarely.
      if (this->Cost[tip] >= unwanted && left < rated)
      {
        rated = this->Crossed ? left - left / 2 : left;
        this->rate();
        tip = this->best();
      }
      this->Crossed = this->Crossed || this->Cost[tip] == never;
      this->clip(tip);
    }
    this->clip(this->First);
    return std::move(this->Result);
  }

private:
  static constexpr double unwanted =
    1e200; ///< flat corners, which would give triangles without area
  static constexpr double never = std::numeric_limits<double>::infinity();

  void rate()
  {
    this->Cost.resize(this->Count);
    std::size_t k = this->First;
    do
    {
      this->Cost[k] = this->costOf(k);
      k = this->Next[k];
    } while (k != this->First);
  }

  /// Square of the perimeter over the area, so that slim ears come last.
  double costOf(std::size_t tip) const
  {
    const Point2& a = this->At[this->Previous[tip]];
    const Point2& b = this->At[tip];
    const Point2& c = this->At[this->Next[tip]];
    if (!isConvex(a, b, c))
    {
      const bool flat = std::abs(cross(b - a, c - a)) <= flatTriangle * longestSquare(a, b, c);
      return flat ? unwanted : never;
    }
    if (!this->isEar(tip))
    {
      return never;
    }
    const double perimeter = (b - a).norm() + (c - b).norm() + (a - c).norm();
    return perimeter * perimeter / cross(b - a, c - a);
  }

  /// Whether the outline stays out of the triangle at a convex corner and off its diagonal.
  bool isEar(std::size_t tip) const
  {
    const std::array<Point2, 3> x{ this->At[this->Previous[tip]], this->At[tip],
      this->At[this->Next[tip]] };
    const Eigen::Array2d least = x[0].cwiseMin(x[1]).cwiseMin(x[2]).array();
    const Eigen::Array2d most = x[0].cwiseMax(x[1]).cwiseMax(x[2]).array();
    for (std::size_t k = this->Next[tip]; k != this->Previous[tip]; k = this->Next[k])
    {
      const Point2& p = this->At[k];
      const Point2& q = this->At[this->Next[k]];
      const bool apart =
        (p.cwiseMax(q).array() < least).any() || (p.cwiseMin(q).array() > most).any();
      if (!apart && (enters(p, q, x) || isInside(q, x) || isBetween(q, x[2], x[0])))
      {
        return false;
      }
    }
    return true;
  }

  static bool isInside(const Point2& p, const std::array<Point2, 3>& x)
  {
    return orientation(x[0], x[1], p) > 0 && orientation(x[1], x[2], p) > 0 &&
      orientation(x[2], x[0], p) > 0;
  }

  /// Whether a segment has a point inside the triangle: no line of a side of either parts the two.
  static bool enters(const Point2& p, const Point2& q, const std::array<Point2, 3>& x)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point2& a = x[k];
      const Point2& b = x[(k + 1) % 3];
      if (orientation(a, b, p) <= 0 && orientation(a, b, q) <= 0)
      {
        return false;
      }
    }
    const std::array<int, 3> sides{ orientation(p, q, x[0]), orientation(p, q, x[1]),
      orientation(p, q, x[2]) };
    const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
    return *least < 0 && *most > 0;
  }

  std::size_t best() const
  {
    std::size_t chosen = this->First;
    for (std::size_t k = this->Next[this->First]; k != this->First; k = this->Next[k])
    {
      chosen = this->Cost[k] < this->Cost[chosen] ? k : chosen;
    }
    return chosen;
  }

  void clip(std::size_t tip)
  {
    const std::size_t a = this->Previous[tip];
    const std::size_t c = this->Next[tip];
    this->Result.push_back({ this->Corners[a], this->Corners[tip], this->Corners[c] });
    this->Next[a] = c;
    this->Previous[c] = a;
    this->First = a;
    this->Cost[a] = this->costOf(a);
    this->Cost[c] = this->costOf(c);
  }

  const Indices& Corners;
  std::size_t Count;
  Points2 At;
  std::vector<std::size_t> Next;
  std::vector<std::size_t> Previous;
  std::vector<double> Cost;
  std::size_t First = 0;
  bool Crossed = false;
  Triangles Result;
};
}

Triangles triangulatePolygon(const Points3& points, const Indices& corners)
{
  return EarClipping(points, corners).run();
}

bool isTriangulationOf(const Triangles& triangles, const Points3& points, const Indices& corners)
{
  const Projection project(points, corners);
  return triangles.size() + 2 == corners.size() &&
    std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
      return isConvex(project(points[t[0]]), project(points[t[1]]), project(points[t[2]]));
    });
}
}
