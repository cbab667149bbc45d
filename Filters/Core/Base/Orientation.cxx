// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Orientation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace flattening
{
namespace
{
/// A sum of doubles kept exactly, as terms that do not overlap, in ascending magnitude.
class ExactSum
{
public:
  void add(double value)
  {
    int kept = 0;
    for (int i = 0; i < this->Count; ++i)
    {
      // Knuth's two-sum: the rounded sum and what it lost.
      const double sum = value + this->Terms[i];
      const double virtualTerm = sum - value;
      const double lost = (value - (sum - virtualTerm)) + (this->Terms[i] - virtualTerm);
      if (lost != 0.0)
      {
        this->Terms[kept++] = lost;
      }
      value = sum;
    }
    if (value != 0.0)
    {
      this->Terms[kept++] = value;
    }
    this->Count = kept;
  }

  void addProduct(double x, double y)
  {
    const double product = x * y;
    this->add(std::fma(x, y, -product));
    this->add(product);
  }

  /// The last term outweighs all before it.
  int sign() const { return this->Count == 0 ? 0 : this->Terms[this->Count - 1] > 0.0 ? 1 : -1; }

private:
  std::array<double, 12> Terms{};
  int Count = 0;
};

int exactOrientation(const Point2& a, const Point2& b, const Point2& c)
{
  ExactSum sum;
  sum.addProduct(a.x(), b.y());
  sum.addProduct(-a.y(), b.x());
  sum.addProduct(b.x(), c.y());
  sum.addProduct(-b.y(), c.x());
  sum.addProduct(c.x(), a.y());
  sum.addProduct(-c.y(), a.x());
  return sum.sign();
}

/// Of collinear points: whether p lies between a and b.
bool between(const Point2& a, const Point2& b, const Point2& p)
{
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
    std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}
}

int orientation(const Point2& a, const Point2& b, const Point2& c)
{
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double determinant = left - right;
  // The first of Shewchuk's error bounds, with his epsilon = half of the machine's.
  constexpr double epsilon = 0.5 * std::numeric_limits<double>::epsilon();
  constexpr double bound = (3.0 + 16.0 * epsilon) * epsilon;
  if (std::abs(determinant) > bound * (std::abs(left) + std::abs(right)))
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return exactOrientation(a, b, c);
}

bool segmentsMeet(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  const int ac = orientation(a, b, c);
  const int ad = orientation(a, b, d);
  const int ca = orientation(c, d, a);
  const int cb = orientation(c, d, b);
  if (ac * ad < 0 && ca * cb < 0)
  {
    return true;
  }
  return (ac == 0 && between(a, b, c)) || (ad == 0 && between(a, b, d)) ||
    (ca == 0 && between(c, d, a)) || (cb == 0 && between(c, d, b));
}

Indices convexHull(const Points2& points)
{
  Indices order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&points](Index a, Index b) {
    const Point2& p = points[a];
    const Point2& q = points[b];
    return p.x() != q.x() ? p.x() < q.x() : p.y() != q.y() ? p.y() < q.y() : a < b;
  });
  Indices hull;
  const auto extend = [&](std::size_t keep, Index i) {
    while (hull.size() > keep &&
      orientation(points[hull[hull.size() - 2]], points[hull.back()], points[i]) <= 0)
    {
      hull.pop_back();
    }
    hull.push_back(i);
  };
  for (Index i : order)
  {
    extend(1, i);
  }
  const std::size_t lower = hull.size();
  for (auto i = order.rbegin() + (order.empty() ? 0 : 1); i != order.rend(); ++i)
  {
    extend(lower, *i);
  }
  if (hull.size() > 1)
  {
    hull.pop_back();
  }
  return hull;
}
}
