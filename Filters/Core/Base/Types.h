// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace flattening
{
/// Raises no floating-point exception, unlike Eigen's allFinite(), which subtracts (version 3.4) or
/// compares (5.0) numbers that are none.
template <typename Derived>
bool isFinite(const Eigen::DenseBase<Derived>& values)
{
  for (Eigen::Index column = 0; column < values.cols(); ++column)
  {
    for (Eigen::Index row = 0; row < values.rows(); ++row)
    {
      if (!std::isfinite(values.derived().coeff(row, column)))
      {
        return false;
      }
    }
  }
  return true;
}

/// Index of a vertex, triangle, half-edge, node, curve ...; -1 means "none".
using Index = std::int32_t;

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;
using Points2 = std::vector<Point2>;
using Points3 = std::vector<Point3>;
using Indices = std::vector<Index>;
using Triangle = std::array<Index, 3>;
using Triangles = std::vector<Triangle>;

inline constexpr Index none = -1;
inline constexpr double pi = 3.141592653589793238462643383279502884;
inline constexpr double degree = pi / 180.0; ///< in radians

/// Whether points are the same to the last bit. Unlike == it tells signed zeros apart, and knows a
/// NaN again.
inline bool sameBits(const Points3& a, const Points3& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data()->data(), b.data()->data(), a.size() * sizeof(Point3)) == 0);
}

/// Takes out the values for which a predicate holds.
template <typename Value, typename Predicate>
void eraseIf(std::vector<Value>& values, const Predicate& predicate)
{
  values.erase(std::remove_if(values.begin(), values.end(), predicate), values.end());
}

/// Ascending, each once.
template <typename Value>
void sortUnique(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// The cross product of two vectors of the plane: the area that they span, positive where v lies to
/// the left of u.
inline double cross(const Point2& u, const Point2& v)
{
  return u.x() * v.y() - u.y() * v.x();
}

/// The same of a triangle's sides: twice its area, positive where it turns anti-clockwise.
inline double cross(const Points2& positions, const Triangle& t)
{
  return cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
}

/// The vertical axis of a body where no other is stated: of y and z that along which it is larger.
inline Eigen::Index upAxisOf(const Point3& sizes)
{
  return sizes.y() > sizes.z() ? 1 : 2;
}

/// The angle between two vectors of space, in [0, pi].
inline double angleBetween(const Point3& u, const Point3& v)
{
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// The point of the segment from a to b that is nearest to another, as a fraction of the way.
template <typename Point>
double fractionAlong(const Point& a, const Point& b, const Point& other)
{
  const Point way = b - a;
  const double square = way.squaredNorm();
  return square > 0.0 ? std::clamp(way.dot(other - a) / square, 0.0, 1.0) : 0.0;
}

/// The length of an open polyline.
template <typename Point>
double polylineLength(const std::vector<Point>& line)
{
  double length = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k)
  {
    length += (line[k] - line[k - 1]).norm();
  }
  return length;
}

/// How far a point of a polyline lies from the segment that joins its ends, at most.
inline double farthestFromChord(const Points2& line)
{
  const Point2& from = line.front();
  const Point2 chord = line.back() - from;
  double farthest = 0.0;
  for (const Point2& p : line)
  {
    farthest = std::max(farthest, (p - from - fractionAlong(from, line.back(), p) * chord).norm());
  }
  return farthest;
}

/// Where a function with one minimum between two places is least, by golden sections.
/// \param narrow the width that ends the search
template <typename Function>
double leastBetween(double low, double high, int sections, double narrow, const Function& function)
{
  constexpr double larger = 0.618033988749894848204586834365638118; // part of a golden section
  for (int k = 0; k < sections && high - low > narrow; ++k)
  {
    const double a = high - larger * (high - low);
    const double b = low + larger * (high - low);
    const bool nearA = function(a) <= function(b);
    (nearA ? high : low) = nearA ? b : a;
  }
  return 0.5 * (low + high);
}
}
