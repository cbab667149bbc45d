// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryWeld.h"

#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace wirewarp
{
namespace
{
using Edge = std::pair<vtkIdType, vtkIdType>;

double distanceOf(vtkPoints* points, vtkIdType p, vtkIdType q)
{
  double x[3];
  double y[3];
  points->GetPoint(p, x);
  points->GetPoint(q, y);
  return std::sqrt(vtkMath::Distance2BetweenPoints(x, y));
}

/// Some of the points, to be found by their places.
class PlacedPoints
{
public:
  PlacedPoints(vtkPoints* all, std::vector<vtkIdType> ids)
    : All(all)
    , Ids(std::move(ids))
  {
    vtkNew<vtkPoints> own;
    own->SetDataTypeToDouble();
    for (const vtkIdType p : this->Ids)
    {
      own->InsertNextPoint(all->GetPoint(p));
    }
    this->Own->SetPoints(own);
    this->Locator->SetDataSet(this->Own);
    this->Locator->BuildLocator();
  }

  /// Those within a distance of one of them, itself among them, in the order of their ids.
  std::vector<std::pair<vtkIdType, double>> near(vtkIdType p, double distance) const
  {
    vtkNew<vtkIdList> found;
    this->Locator->FindPointsWithinRadius(distance, this->All->GetPoint(p), found);
    std::vector<std::pair<vtkIdType, double>> points;
    for (vtkIdType k = 0; k < found->GetNumberOfIds(); ++k)
    {
      const vtkIdType q = this->Ids[static_cast<std::size_t>(found->GetId(k))];
      points.emplace_back(q, distanceOf(this->All, p, q));
    }
    std::sort(points.begin(), points.end());
    return points;
  }

private:
  vtkPoints* All;
  std::vector<vtkIdType> Ids;
  vtkNew<vtkPolyData> Own;
  vtkNew<vtkStaticPointLocator> Locator;
};
}

//------------------------------------------------------------------------------
WeldedPoints weldBoundary(TriangleList& list, double coincident, double distance)
{
  const std::vector<vtkIdType> boundary = boundaryPoints(list);
  WeldedPoints welded;
  if (boundary.empty())
  {
    return welded;
  }
  std::set<Edge> edges;
  for (const ListedTriangle& triangle : list.triangles)
  {
    for (std::size_t k = 0; k < 3 && distance > coincident; ++k)
    {
      edges.insert(std::minmax(triangle.corners[k], triangle.corners[(k + 1) % 3]));
    }
  }
  const PlacedPoints placed(list.points, boundary);
  std::unordered_map<vtkIdType, vtkIdType> joined;
  std::unordered_map<vtkIdType, std::vector<vtkIdType>> members; // of each point that is kept
  for (const vtkIdType p : boundary)
  {
    std::pair<double, vtkIdType> nearest{ std::numeric_limits<double>::infinity(), p };
    for (const auto& [q, away] : placed.near(p, std::max(coincident, distance)))
    {
      const auto cluster = members.find(q);
      if (cluster == members.end() || away >= nearest.first)
      {
        continue;
      }
      const std::vector<vtkIdType>& points = cluster->second;
      if (away <= coincident || std::none_of(points.begin(), points.end(), [&, p](vtkIdType m) {
            return edges.count(std::minmax(p, m)) > 0;
          }))
      {
        nearest = { away, q };
      }
    }
    members[nearest.second].push_back(p);
    if (nearest.second != p)
    {
      joined[p] = nearest.second;
      welded.farthest = std::max(welded.farthest, nearest.first);
    }
  }
  for (ListedTriangle& triangle : list.triangles)
  {
    for (vtkIdType& corner : triangle.corners)
    {
      const auto to = joined.find(corner);
      corner = to == joined.end() ? corner : to->second;
    }
  }
  welded.count = joined.size();
  return welded;
}

//------------------------------------------------------------------------------
UnjoinedBoundary unjoinedEdges(
  const TriangleList& list, const std::vector<BoundaryLoop>& loops, double coincident, double near)
{
  std::set<Edge> edges;
  std::map<vtkIdType, double> shortest; // edge at a point
  for (const BoundaryLoop& loop : loops)
  {
    for (std::size_t k = 0; k < loop.points.size(); ++k)
    {
      const Edge edge = std::minmax(loop.points[k], loop.points[(k + 1) % loop.points.size()]);
      const double length = distanceOf(list.points, edge.first, edge.second);
      edges.insert(edge);
      for (const vtkIdType p : { edge.first, edge.second })
      {
        const auto at = shortest.emplace(p, length).first;
        at->second = std::min(at->second, length);
      }
    }
  }
  UnjoinedBoundary unjoined;
  if (edges.empty())
  {
    return unjoined;
  }
  std::vector<vtkIdType> ids;
  for (const auto& [p, length] : shortest)
  {
    ids.push_back(p);
  }
  const PlacedPoints placed(list.points, ids);
  std::map<vtkIdType, std::vector<std::pair<vtkIdType, double>>> partners;
  for (const auto& [p, length] : shortest)
  {
    partners[p] = placed.near(p, std::max(coincident, std::min(near, 0.1 * length)));
  }
  for (const Edge& edge : edges)
  {
    double gap = std::numeric_limits<double>::infinity();
    for (const auto& [a, distanceA] : partners[edge.first])
    {
      for (const auto& [b, distanceB] : partners[edge.second])
      {
        const double distance = std::max(distanceA, distanceB);
        // Beside a tip, which its sides share, a cut is narrow by nature.
        const bool apart = a != edge.first && b != edge.second;
        const Edge other = std::minmax(a, b);
        if ((apart || distance <= coincident) && other != edge && edges.count(other) > 0)
        {
          gap = std::min(gap, distance);
        }
      }
    }
    if (std::isfinite(gap))
    {
      UnjoinedEdges& found = gap <= coincident ? unjoined.coincident : unjoined.near;
      found.point = found.count == 0 ? edge.first : std::min(found.point, edge.first);
      found.gap = std::max(found.gap, gap);
      ++found.count;
    }
  }
  return unjoined;
}
}
