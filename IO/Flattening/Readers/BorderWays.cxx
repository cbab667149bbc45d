// SPDX-License-Identifier: BSD-3-Clause
#include "BorderWays.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wirewarp
{
namespace
{
/// Two ways round whose lengths differ by less, as a fraction of the loop, are alike.
constexpr double alike = 1e-6;
}

//------------------------------------------------------------------------------
BorderWays::BorderWays(vtkPolyData* surface)
{
  const TriangleList list = listTriangles(surface);
  this->Points = list.points;
  this->Loops = boundaryLoops(list);
  for (std::size_t l = 0; l < this->Loops.size(); ++l)
  {
    const std::vector<vtkIdType>& points = this->Loops[l].points;
    std::vector<double>& arc = this->Arc.emplace_back(1, 0.0);
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      double from[3];
      double to[3];
      list.points->GetPoint(points[k], from);
      list.points->GetPoint(points[(k + 1) % points.size()], to);
      arc.push_back(arc.back() + std::sqrt(vtkMath::Distance2BetweenPoints(from, to)));
      const auto [place, isNew] = this->Places.emplace(points[k], Place{ l, k });
      place->second.unique = isNew;
    }
  }
}

//------------------------------------------------------------------------------
std::optional<std::vector<vtkIdType>> BorderWays::through(
  const std::vector<vtkIdType>& points, std::string& fault) const
{
  for (const vtkIdType point : points)
  {
    const auto found = this->Places.find(point);
    if (found == this->Places.end())
    {
      fault = "vertex " + std::to_string(point) +
        " is not on the boundary of the surface; name vertices of it, or make the curve accessory";
      return std::nullopt;
    }
    if (!found->second.unique)
    {
      fault = "the boundary comes through vertex " + std::to_string(point) +
        " more than once; end the edge beside it";
      return std::nullopt;
    }
  }
  std::vector<vtkIdType> way{ points.front() };
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
  {
    if (!this->add(points[k], points[k + 1], way, fault))
    {
      return std::nullopt;
    }
  }
  return way;
}

//------------------------------------------------------------------------------
vtkIdType BorderWays::nearest(const double place[3], double& distance) const
{
  vtkIdType best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const BoundaryLoop& loop : this->Loops)
  {
    for (const vtkIdType point : loop.points)
    {
      double x[3];
      this->Points->GetPoint(point, x);
      const double square = vtkMath::Distance2BetweenPoints(place, x);
      if (square < least)
      {
        least = square;
        best = point;
      }
    }
  }
  distance = std::sqrt(least);
  return best;
}

//------------------------------------------------------------------------------
bool BorderWays::add(
  vtkIdType from, vtkIdType to, std::vector<vtkIdType>& way, std::string& fault) const
{
  const Place& start = this->Places.at(from);
  const Place& end = this->Places.at(to);
  const std::string both = "vertices " + std::to_string(from) + " and " + std::to_string(to);
  if (start.loop != end.loop)
  {
    fault = both + " are on different boundaries; make an edge of each";
    return false;
  }
  const std::vector<vtkIdType>& points = this->Loops[start.loop].points;
  const std::vector<double>& arc = this->Arc[start.loop];
  const double length = arc.back();
  double forward = arc[end.at] - arc[start.at];
  forward += forward > 0.0 ? 0.0 : length; // to the same point: all the way round
  if (from != to && std::abs(2.0 * forward - length) < alike * length)
  {
    fault = "both ways along the boundary between " + both +
      " are of one length; name a vertex between them as well";
    return false;
  }
  const std::size_t count = points.size();
  const std::size_t step = from == to || 2.0 * forward < length ? 1 : count - 1;
  std::size_t k = start.at;
  do
  {
    k = (k + step) % count;
    way.push_back(points[k]);
  } while (k != end.at);
  return true;
}
}
