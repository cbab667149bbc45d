// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SheetLocator.h"

#include "Base/CompressedRows.h"

#include <algorithm>
#include <map>
#include <utility>

namespace flattening
{
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
