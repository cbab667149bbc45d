// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceLocator.h"

#include "Base/CompressedRows.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{
/// Triangles a leaf: to measure so few takes no longer than another two boxes.
constexpr Index leafSize = 4;

std::array<double, 3> along(int from, int to, double fraction)
{
  std::array<double, 3> weights{ 0.0, 0.0, 0.0 };
  weights[from] = 1.0 - fraction;
  weights[to] = fraction;
  return weights;
}

/// Barycentric coordinates of the closest point of a triangle, by its Voronoi regions
/// (C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
std::array<double, 3> closestWeights(
  const Point3& a, const Point3& b, const Point3& c, const Point3& p)
{
  const Point3 ab = b - a;
  const Point3 ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return along(0, 1, 0.0);
  }
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return along(1, 2, 0.0);
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3)
  {
    return along(0, 1, d1 / (d1 - d3));
  }
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return along(2, 0, 0.0);
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6)
  {
    return along(0, 2, d2 / (d2 - d6));
  }
  const double va = d3 * d6 - d5 * d4;
  const double toC = d4 - d3;
  const double toB = d5 - d6;
  const double sum = va + vb + vc;
  if ((va <= 0.0 && toC >= 0.0 && toB >= 0.0 && toC + toB > 0.0) || !(sum > 0.0))
  {
    const double whole = toC + toB;
    return along(1, 2, whole > 0.0 ? std::clamp(toC / whole, 0.0, 1.0) : 0.0);
  }
  return { va / sum, vb / sum, vc / sum };
}
}

SurfaceLocator::SurfaceLocator(const TriangleMesh& mesh)
  : Mesh(mesh)
  , Order(mesh.triangleCount())
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  Points3 centers(mesh.triangleCount());
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    centers[t] = mesh.centroid(t);
  }
  if (!this->Order.empty())
  {
    this->Nodes.reserve(this->Order.size());
    this->build(0, mesh.triangleCount(), centers);
  }
}

Index SurfaceLocator::build(Index begin, Index end, const Points3& centers)
{
  const Index id = static_cast<Index>(this->Nodes.size());
  this->Nodes.emplace_back();
  this->Nodes[id].begin = begin;
  this->Nodes[id].end = end;
  Eigen::AlignedBox3d box;
  if (end - begin <= leafSize)
  {
    for (Index i = begin; i < end; ++i)
    {
      for (Index v : this->Mesh.triangle(this->Order[i]))
      {
        box.extend(this->Mesh.point(v));
      }
    }
    this->Nodes[id].box = box;
    return id;
  }
  for (Index i = begin; i < end; ++i)
  {
    box.extend(centers[this->Order[i]]);
  }
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(this->Order.begin() + begin, this->Order.begin() + middle,
    this->Order.begin() + end, [&centers, axis](Index s, Index t) {
      return centers[s][axis] != centers[t][axis] ? centers[s][axis] < centers[t][axis] : s < t;
    });
  const Index left = this->build(begin, middle, centers);
  const Index right = this->build(middle, end, centers);
  this->Nodes[id].box = this->Nodes[left].box.merged(this->Nodes[right].box);
  this->Nodes[id].right = right;
  return id;
}

ClosestPoint SurfaceLocator::closest(const Point3& point) const
{
  const std::vector<ClosestPoint> all = this->allClosest(point, 0.0);
  return all.empty() ? ClosestPoint() : all.front();
}

std::vector<ClosestPoint> SurfaceLocator::allClosest(const Point3& point, double farther) const
{
  std::vector<ClosestPoint> found;
  if (this->Nodes.empty())
  {
    return found;
  }
  double least = std::numeric_limits<double>::infinity();
  double asClose = least;
  std::vector<std::pair<double, Index>> stack;
  stack.emplace_back(this->Nodes[0].box.squaredExteriorDistance(point), 0);
  while (!stack.empty())
  {
    const auto [bound, id] = stack.back();
    stack.pop_back();
    if (bound > asClose * asClose)
    {
      continue;
    }
    const Node& node = this->Nodes[id];
    if (node.right != none)
    {
      std::pair<double, Index> left{ this->Nodes[id + 1].box.squaredExteriorDistance(point),
        id + 1 };
      std::pair<double, Index> right{ this->Nodes[node.right].box.squaredExteriorDistance(point),
        node.right };
      const bool leftFirst = left.first <= right.first;
      stack.push_back(leftFirst ? right : left);
      stack.push_back(leftFirst ? left : right);
      continue;
    }
    for (Index i = node.begin; i < node.end; ++i)
    {
      const Index t = this->Order[i];
      const Triangle& c = this->Mesh.triangle(t);
      const Point3& a = this->Mesh.point(c[0]);
      const Point3& b = this->Mesh.point(c[1]);
      const Point3& d = this->Mesh.point(c[2]);
      const std::array<double, 3> w = closestWeights(a, b, d, point);
      const Point3 position = w[0] * a + w[1] * b + w[2] * d;
      const double distance = (position - point).norm();
      if (distance <= asClose)
      {
        found.push_back({ t, w, position, distance });
      }
      if (distance < least)
      {
        least = distance;
        asClose = (1.0 + equalDistances) * least + farther;
      }
    }
  }
  eraseIf(found, [asClose](const ClosestPoint& one) { return one.distance > asClose; });
  std::sort(found.begin(), found.end(),
    [](const ClosestPoint& a, const ClosestPoint& b) { return a.triangle < b.triangle; });
  return found;
}

namespace
{
/// Of the surface's diagonal: points of the surface that differ by less, in rounding, are one
/// place.
constexpr double samePlaceShare = 1e-9;

bool share(const std::vector<ClosestPoint>& a, const std::vector<ClosestPoint>& b)
{
  return std::any_of(a.begin(), a.end(), [&b](const ClosestPoint& one) {
    return std::any_of(b.begin(), b.end(),
      [&one](const ClosestPoint& other) { return other.triangle == one.triangle; });
  });
}
}

SheetLocator::SheetLocator(const TriangleMesh& mesh)
  : Mesh(mesh)
  , Locator(mesh)
  , SamePlace(samePlaceShare * this->Locator.diagonal())
{
}

/// The triangles at a place of the surface, together those that share edges.
std::vector<std::vector<ClosestPoint>> SheetLocator::sheetsAt(const Point3& point) const
{
  std::vector<ClosestPoint> all = this->Locator.allClosest(point, this->SamePlace);
  JoinedSets joined(static_cast<Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    for (Index h = 3 * all[i].triangle; h < 3 * all[i].triangle + 3; ++h)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (this->Mesh.twin(h) != none && this->Mesh.twin(h) / 3 == all[j].triangle)
        {
          joined.join(static_cast<Index>(i), static_cast<Index>(j));
        }
      }
    }
  }
  std::map<Index, std::vector<ClosestPoint>> sheets; // by the first of each
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    sheets[joined.find(static_cast<Index>(i))].push_back(all[i]);
  }
  std::vector<std::vector<ClosestPoint>> result;
  for (auto& [first, sheet] : sheets)
  {
    result.push_back(std::move(sheet));
  }
  std::sort(result.begin(), result.end(),
    [](const auto& a, const auto& b) { return a.front().triangle < b.front().triangle; });
  return result;
}

/// As few steps as possible lead from one part of the surface to another, then from one triangle to
/// another; then the smaller ids win.
std::vector<SheetLocator::Place> SheetLocator::along(const Points3& line) const
{
  std::vector<Place> places(line.size());
  std::vector<std::vector<std::vector<ClosestPoint>>> sheets;
  bool several = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    sheets.push_back(this->sheetsAt(line[i]));
    several = several || sheets.back().size() > 1;
    for (const ClosestPoint& one : sheets[i].empty() ? std::vector<ClosestPoint>() : sheets[i][0])
    {
      const bool closer = one.distance * (1.0 + equalDistances) < places[i].closest.distance;
      places[i].closest = places[i].closest.triangle == none || closer ? one : places[i].closest;
    }
  }
  if (!several)
  {
    return places;
  }
  if (this->Parts.empty())
  {
    connectedParts(this->Mesh, {}, this->Parts);
  }
  const auto part = [this](const std::vector<ClosestPoint>& sheet) {
    return this->Parts[sheet.front().triangle];
  };
  // Dynamic programming along the line, backwards: per sheet the least cost from there on.
  const auto otherPart = static_cast<Index>(line.size());
  std::vector<Indices> cost(sheets.size());
  std::vector<Indices> next(sheets.size());
  for (std::size_t i = sheets.size(); i-- > 0;)
  {
    cost[i].assign(sheets[i].size(), 0);
    next[i].assign(sheets[i].size(), none);
    for (std::size_t k = 0; i + 1 < sheets.size() && k < sheets[i].size(); ++k)
    {
      for (std::size_t j = 0; j < sheets[i + 1].size(); ++j)
      {
        const bool same = part(sheets[i][k]) == part(sheets[i + 1][j]);
        const Index sum = cost[i + 1][j] +
          (!same                                      ? otherPart
              : share(sheets[i][k], sheets[i + 1][j]) ? 0
                                                      : 1);
        if (next[i][k] == none || sum < cost[i][k])
        {
          cost[i][k] = sum;
          next[i][k] = static_cast<Index>(j);
        }
      }
    }
  }
  auto at = static_cast<Index>(std::min_element(cost[0].begin(), cost[0].end()) - cost[0].begin());
  for (std::size_t i = 0; i < sheets.size(); at = next[i++][at])
  {
    if (sheets[i].size() > 1)
    {
      places[i].closest = sheets[i][at].front();
      for (const ClosestPoint& one : sheets[i][at])
      {
        places[i].sheet.push_back(one.triangle);
      }
    }
  }
  return places;
}
}
