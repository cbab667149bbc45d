// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryLoops.h"

#include "Base/CompressedRows.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace wirewarp
{
namespace
{
struct Side
{
  std::int64_t to = 0;
  std::int64_t polygon = 0;
};

std::uint64_t mixed(std::int64_t id)
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
  std::vector<std::uint64_t> balance(list.points->size(), 0);
  for (const ListedTriangle& triangle : list.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int64_t from = triangle.corners[k];
      const std::int64_t to = triangle.corners[(k + 1) % 3];
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
std::multimap<std::int64_t, Side> boundarySides(const TriangleList& list)
{
  const std::vector<char> questionable = pointsInQuestion(list);
  std::map<std::pair<std::int64_t, std::int64_t>, int> uses;
  const auto forEachSide = [&](const auto& visit) {
    for (const ListedTriangle& triangle : list.triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::int64_t from = triangle.corners[k];
        const std::int64_t to = triangle.corners[(k + 1) % 3];
        if (questionable[static_cast<std::size_t>(from)] != 0 &&
          questionable[static_cast<std::size_t>(to)] != 0)
        {
          visit(from, to, triangle.polygon);
        }
      }
    }
  };
  forEachSide(
    [&uses](std::int64_t from, std::int64_t to, std::int64_t) { ++uses[std::minmax(from, to)]; });
  std::multimap<std::int64_t, Side> sides;
  forEachSide([&](std::int64_t from, std::int64_t to, std::int64_t polygon) {
    if (uses.at(std::minmax(from, to)) == 1)
    {
      sides.emplace(from, Side{ to, polygon });
    }
  });
  return sides;
}

double lengthOf(const TriangleList& list, const std::vector<std::int64_t>& loop)
{
  double length = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    length += (list.point(loop[k]) - list.point(loop[(k + 1) % loop.size()])).norm();
  }
  return length;
}

void markOutermost(const TriangleList& list, std::vector<BoundaryLoop>& loops)
{
  flattening::JoinedSets parts(static_cast<flattening::Index>(list.points->size()));
  const auto indexOf = [](std::int64_t point) { return static_cast<flattening::Index>(point); };
  for (const ListedTriangle& triangle : list.triangles)
  {
    parts.join(indexOf(triangle.corners[0]), indexOf(triangle.corners[1]));
    parts.join(indexOf(triangle.corners[0]), indexOf(triangle.corners[2]));
  }
  std::map<std::int64_t, std::pair<double, std::size_t>> longest;
  for (std::size_t k = 0; k < loops.size(); ++k)
  {
    const double length = loops[k].length;
    auto& best = longest[parts.find(indexOf(loops[k].points.front()))];
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

std::vector<BoundaryLoop> boundaryLoops(const TriangleList& list)
{
  std::multimap<std::int64_t, Side> sides = boundarySides(list);
  std::vector<BoundaryLoop> loops;
  while (!sides.empty())
  {
    BoundaryLoop loop;
    Eigen::AlignedBox3d box;
    loop.polygon = sides.begin()->second.polygon;
    // Where triangles are turned over against each other a way may end before it is closed.
    for (auto at = sides.begin(); at != sides.end(); at = sides.find(loop.points.back()))
    {
      if (loop.points.empty())
      {
        loop.points.push_back(at->first);
      }
      const std::int64_t next = at->second.to;
      sides.erase(at);
      box.extend(list.point(loop.points.back()));
      if (next == loop.points.front())
      {
        loop.across = box.diagonal().norm();
        loop.length = lengthOf(list, loop.points);
        loops.push_back(loop);
        break;
      }
      loop.points.push_back(next);
    }
  }
  markOutermost(list, loops);
  return loops;
}

std::vector<BoundaryLoop> openings(const TriangleList& list)
{
  std::vector<BoundaryLoop> loops = boundaryLoops(list);
  std::stable_sort(loops.begin(), loops.end(),
    [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.length > b.length; });
  return loops;
}

std::vector<std::int64_t> boundaryPoints(const TriangleList& list)
{
  std::set<std::int64_t> points;
  for (const auto& [from, side] : boundarySides(list))
  {
    points.insert(from);
    points.insert(side.to);
  }
  return { points.begin(), points.end() };
}
}
