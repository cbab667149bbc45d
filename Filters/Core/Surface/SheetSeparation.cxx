// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SheetSeparation.h"

#include "Base/CompressedRows.h"
#include "Surface/SurfacePreparation.h"
#include "Surface/TriangleMesh.h"

#include <algorithm>
#include <map>

namespace flattening
{
namespace
{
/// The fans of triangles at points: sets of corners.
JoinedSets fansOf(const Triangles& triangles, const Indices& partner)
{
  JoinedSets corners(static_cast<Index>(3 * triangles.size()));
  const auto next = [](Index h) { return TriangleMesh::next(h); };
  const auto start = [&triangles](Index h) { return triangles[h / 3][h % 3]; };
  for (std::size_t k = 0; k < partner.size(); ++k)
  {
    const Index h = static_cast<Index>(k);
    const Index g = partner[k];
    if (g != none)
    {
      const bool alike = start(h) != start(g); // neighbors may still be oriented differently
      corners.join(h, alike ? next(g) : g);
      corners.join(next(h), alike ? g : next(g));
    }
  }
  return corners;
}
}

std::pair<Index, Index> endsOf(const Triangles& triangles, Index h)
{
  const Triangle& t = triangles[h / 3];
  return std::minmax({ t[h % 3], t[(h + 1) % 3] });
}

Indices partOneSided(
  const Triangles& triangles, const std::vector<Indices>& crowded, Indices& partner)
{
  const Index count = static_cast<Index>(triangles.size());
  JoinedSets sides(2 * count); // of each triangle, and behind them of each turned over
  const auto start = [&triangles](Index h) { return triangles[h / 3][h % 3]; };
  const auto join = [&](Index h, Index g) {
    const Index turn = start(h) != start(g) ? 0 : count;
    const bool opposed = sides.find(h / 3) == sides.find(g / 3 + count - turn);
    if (!opposed)
    {
      sides.join(h / 3, g / 3 + turn);
      sides.join(h / 3 + count, g / 3 + count - turn);
    }
    return !opposed;
  };
  enum Order : char
  {
    Alike, // as they are: these never contradict each other
    Turned,
    Crowded
  };
  std::vector<Order> orders;
  for (std::size_t h = 0; h < partner.size(); ++h)
  {
    const bool turned = partner[h] != none && start(static_cast<Index>(h)) == start(partner[h]);
    orders.push_back(turned ? Turned : Alike);
  }
  for (const Indices& edge : crowded)
  {
    for (const Index h : edge)
    {
      orders[h] = Crowded;
    }
  }
  Indices parted;
  for (const Order now : { Alike, Turned, Crowded })
  {
    for (std::size_t k = 0; k < partner.size(); ++k)
    {
      const Index h = static_cast<Index>(k);
      const Index g = partner[k];
      if (orders[k] == now && g > h && !join(h, g))
      {
        partner[h] = partner[g] = none;
        parted.insert(parted.end(), now == Turned ? 1 : 0, h);
      }
    }
  }
  return parted;
}

Indices partAtEnds(const Triangles& triangles, std::size_t points, bool pairs, Indices& partner)
{
  Indices opened;
  std::vector<Indices> edges = crowdedEdges(sortedSides(triangles, points), pairs ? 2 : 3);
  eraseIf(edges,
    [&partner](const Indices& edge) { return edge.size() == 2 && partner[edge.front()] != none; });
  const auto start = [&triangles](Index h) { return triangles[h / 3][h % 3]; };
  const auto next = [](Index h) { return TriangleMesh::next(h); };
  for (std::size_t before = 1; before > 0;)
  {
    before = 0;
    JoinedSets fans = fansOf(triangles, partner);
    for (const Indices& edge : edges)
    {
      const Index low = endsOf(triangles, edge.front()).first;
      std::map<std::pair<Index, Index>, Index> first; // by the fans at both ends
      for (const Index h : edge)
      {
        const Index atLow = start(h) == low ? h : next(h);
        const Index atHigh = start(h) == low ? next(h) : h;
        const Index kept =
          first.emplace(std::pair(fans.find(atLow), fans.find(atHigh)), h).first->second;
        if (kept == h || partner[h] == kept)
        {
          continue;
        }
        for (const Index side : { h, partner[h] })
        {
          // The other side of the triangle at the lower end.
          const Index other = side == none ? none
            : start(side) == low           ? next(next(side))
                                           : next(side);
          if (other != none && partner[other] != none)
          {
            const auto [from, to] = endsOf(triangles, other);
            opened.insert(opened.end(), { from, to });
            partner[partner[other]] = none;
            partner[other] = none;
            ++before;
          }
        }
      }
    }
  }
  return opened;
}

Indices splitFans(Triangles& triangles, Points3& points, Indices& source, const Indices& partner)
{
  JoinedSets corners = fansOf(triangles, partner);
  const auto start = [&triangles](Index h) { return triangles[h / 3][h % 3]; };
  Indices fanOf(points.size(), none); // the first
  Indices pinched;
  for (Index h = 0; h < static_cast<Index>(partner.size()); ++h)
  {
    Index& fan = fanOf[start(h)];
    fan = fan == none ? corners.find(h) : fan;
    if (fan != corners.find(h))
    {
      pinched.push_back(start(h));
    }
  }
  sortUnique(pinched);
  if (pinched.empty())
  {
    return pinched;
  }
  std::map<Index, std::map<Index, Indices>> fans; // of pinched points, by their least corner
  for (Index h = 0; h < static_cast<Index>(partner.size()); ++h)
  {
    if (std::binary_search(pinched.begin(), pinched.end(), start(h)))
    {
      fans[start(h)][corners.find(h)].push_back(h);
    }
  }
  for (const auto& [point, ofPoint] : fans)
  {
    const auto most = std::max_element(ofPoint.begin(), ofPoint.end(),
      [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    for (auto fan = ofPoint.begin(); fan != ofPoint.end(); ++fan)
    {
      if (fan == most)
      {
        continue;
      }
      for (const Index h : fan->second)
      {
        triangles[h / 3][h % 3] = static_cast<Index>(points.size());
      }
      points.emplace_back(points[point]);
      source.push_back(point);
    }
  }
  return pinched;
}
}
