// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryLoops.h"

#include <vtkBoundingBox.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace wirewarp
{
namespace
{
using Place = std::array<double, 3>;

struct Side
{
  vtkIdType to = 0;
  vtkIdType polygon = 0;
};

std::uint64_t mixed(vtkIdType id)
{
  // The finalizer of SplitMix64.
  std::uint64_t z = static_cast<std::uint64_t>(id) + 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// Points that are not surrounded by triangles of one orientation: those on the boundary are among
/// them. Around any other each neighbour is entered as often as it is left.
std::vector<char> pointsInQuestion(const TriangleList& list)
{
  std::vector<std::uint64_t> balance(static_cast<std::size_t>(list.points->GetNumberOfPoints()), 0);
  for (const ListedTriangle& triangle : list.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const vtkIdType from = triangle.corners[k];
      const vtkIdType to = triangle.corners[(k + 1) % 3];
      balance[static_cast<std::size_t>(from)] += mixed(to);
      balance[static_cast<std::size_t>(to)] -= mixed(from);
    }
  }
  std::vector<char> questionable(balance.size());
  std::transform(balance.begin(), balance.end(), questionable.begin(),
    [](std::uint64_t sum) { return static_cast<char>(sum != 0); });
  return questionable;
}

/// The sides of triangles that no other triangle shares, by the point that they start at.
std::multimap<vtkIdType, Side> boundarySides(const TriangleList& list)
{
  const std::vector<char> questionable = pointsInQuestion(list);
  std::map<std::pair<vtkIdType, vtkIdType>, int> uses;
  const auto forEachSide = [&](const auto& visit) {
    for (const ListedTriangle& triangle : list.triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const vtkIdType from = triangle.corners[k];
        const vtkIdType to = triangle.corners[(k + 1) % 3];
        if (questionable[static_cast<std::size_t>(from)] != 0 &&
          questionable[static_cast<std::size_t>(to)] != 0)
        {
          visit(from, to, triangle.polygon);
        }
      }
    }
  };
  forEachSide([&uses](vtkIdType from, vtkIdType to, vtkIdType) { ++uses[std::minmax(from, to)]; });
  std::multimap<vtkIdType, Side> sides;
  forEachSide([&](vtkIdType from, vtkIdType to, vtkIdType polygon) {
    if (uses.at(std::minmax(from, to)) == 1)
    {
      sides.emplace(from, Side{ to, polygon });
    }
  });
  return sides;
}

double lengthOf(vtkPoints* points, const std::vector<vtkIdType>& loop)
{
  double length = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    Place a;
    Place b;
    points->GetPoint(loop[k], a.data());
    points->GetPoint(loop[(k + 1) % loop.size()], b.data());
    length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  return length;
}

/// Connected parts of the surface, by the points that stand for them.
class Parts
{
public:
  explicit Parts(const TriangleList& list)
    : Parent(static_cast<std::size_t>(list.points->GetNumberOfPoints()))
  {
    for (std::size_t p = 0; p < this->Parent.size(); ++p)
    {
      this->Parent[p] = static_cast<vtkIdType>(p);
    }
    for (const ListedTriangle& triangle : list.triangles)
    {
      this->join(triangle.corners[0], triangle.corners[1]);
      this->join(triangle.corners[0], triangle.corners[2]);
    }
  }
  vtkIdType of(vtkIdType point)
  {
    for (;;)
    {
      vtkIdType& parent = this->Parent[static_cast<std::size_t>(point)];
      if (parent == point)
      {
        return point;
      }
      parent = this->Parent[static_cast<std::size_t>(parent)];
      point = parent;
    }
  }

private:
  void join(vtkIdType a, vtkIdType b)
  {
    const vtkIdType first = this->of(a);
    const vtkIdType second = this->of(b);
    this->Parent[static_cast<std::size_t>(std::max(first, second))] = std::min(first, second);
  }

  std::vector<vtkIdType> Parent;
};

void markOutermost(const TriangleList& list, std::vector<BoundaryLoop>& loops)
{
  Parts parts(list);
  std::unordered_map<vtkIdType, std::pair<double, std::size_t>> longest;
  for (std::size_t k = 0; k < loops.size(); ++k)
  {
    const double length = loops[k].length;
    auto& best = longest[parts.of(loops[k].points.front())];
    if (length > best.first)
    {
      best = { length, k };
    }
  }
  for (const auto& [part, best] : longest)
  {
    loops[best.second].outermost = true;
  }
}
}

//------------------------------------------------------------------------------
std::vector<BoundaryLoop> boundaryLoops(const TriangleList& list)
{
  std::multimap<vtkIdType, Side> sides = boundarySides(list);
  std::vector<BoundaryLoop> loops;
  while (!sides.empty())
  {
    BoundaryLoop loop;
    vtkBoundingBox box;
    loop.polygon = sides.begin()->second.polygon;
    // Where triangles are turned over against each other a way may end before it is closed.
    for (auto at = sides.begin(); at != sides.end(); at = sides.find(loop.points.back()))
    {
      if (loop.points.empty())
      {
        loop.points.push_back(at->first);
      }
      const vtkIdType next = at->second.to;
      sides.erase(at);
      Place x;
      list.points->GetPoint(loop.points.back(), x.data());
      box.AddPoint(x.data());
      if (next == loop.points.front())
      {
        loop.across = box.GetDiagonalLength();
        loop.length = lengthOf(list.points, loop.points);
        loops.push_back(loop);
        break;
      }
      loop.points.push_back(next);
    }
  }
  markOutermost(list, loops);
  return loops;
}

//------------------------------------------------------------------------------
std::vector<BoundaryLoop> openings(const TriangleList& list)
{
  std::vector<BoundaryLoop> loops = boundaryLoops(list);
  std::stable_sort(loops.begin(), loops.end(),
    [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.length > b.length; });
  return loops;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> boundaryPoints(const TriangleList& list)
{
  std::set<vtkIdType> points;
  for (const auto& [from, side] : boundarySides(list))
  {
    points.insert(from);
    points.insert(side.to);
  }
  return { points.begin(), points.end() };
}
}
