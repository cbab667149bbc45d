// SPDX-License-Identifier: BSD-3-Clause
#include "BorderWays.h"

#include "Base/Types.h"
#include "InputError.h"

#include <cmath>
#include <limits>
#include <string>

namespace wirewarp
{
namespace
{
/// Two ways round whose lengths differ by less, as a fraction of the loop, are alike.
constexpr double alike = 1e-6;
}

BorderWays::BorderWays(const DataSet& surface)
{
  const TriangleList list = listTriangles(surface);
  this->Points = list.points;
  this->Loops = boundaryLoops(list);
  for (std::size_t l = 0; l < this->Loops.size(); ++l)
  {
    const std::vector<std::int64_t>& points = this->Loops[l].points;
    std::vector<double>& arc = this->Arc.emplace_back(1, 0.0);
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const Point3& from = list.point(points[k]);
      const Point3& to = list.point(points[(k + 1) % points.size()]);
      arc.push_back(arc.back() + (to - from).norm());
      const auto [place, isNew] = this->Places.emplace(points[k], Place{ l, k });
      place->second.unique = isNew;
    }
  }
}

std::vector<std::int64_t> BorderWays::through(const std::vector<std::int64_t>& points) const
{
  for (const std::int64_t point : points)
  {
    const auto found = this->Places.find(point);
    if (found == this->Places.end())
    {
      throw InputError("vertex " + std::to_string(point) +
        " is not on the boundary of the surface; name vertices of it, or make the curve accessory");
    }
    if (!found->second.unique)
    {
      throw InputError("the boundary comes through vertex " + std::to_string(point) +
        " more than once; end the edge beside it");
    }
  }
  std::vector<std::int64_t> way{ points.front() };
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
  {
    this->add(points[k], points[k + 1], way);
  }
  return way;
}

std::int64_t BorderWays::nearest(const Point3& place, double& distance) const
{
  std::int64_t best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const BoundaryLoop& loop : this->Loops)
  {
    for (std::size_t k = 0; k < loop.points.size(); ++k)
    {
      const std::int64_t from = loop.points[k];
      const std::int64_t to = loop.points[(k + 1) % loop.points.size()];
      const Point3& a = (*this->Points)[static_cast<std::size_t>(from)];
      const Point3& b = (*this->Points)[static_cast<std::size_t>(to)];
      const double along = flattening::fractionAlong(a, b, place);
      const double square = (a + along * (b - a) - place).squaredNorm();
      if (square < least)
      {
        least = square;
        best = along < 0.5 ? from : to;
      }
    }
  }
  distance = std::sqrt(least);
  return best;
}

void BorderWays::add(std::int64_t from, std::int64_t to, std::vector<std::int64_t>& way) const
{
  const Place& start = this->Places.at(from);
  const Place& end = this->Places.at(to);
  const std::string both = "vertices " + std::to_string(from) + " and " + std::to_string(to);
  if (start.loop != end.loop)
  {
    throw InputError(both + " are on different boundaries; make an edge of each");
  }
  const std::vector<std::int64_t>& points = this->Loops[start.loop].points;
  const std::vector<double>& arc = this->Arc[start.loop];
  const double length = arc.back();
  double forward = arc[end.at] - arc[start.at];
  forward += forward > 0.0 ? 0.0 : length; // to the same point: all the way round
  if (from != to && std::abs(2.0 * forward - length) < alike * length)
  {
    throw InputError("both ways along the boundary between " + both +
      " are of one length; name a vertex between them as well");
  }
  const std::size_t count = points.size();
  const std::size_t step = from == to || 2.0 * forward < length ? 1 : count - 1;
  std::size_t k = start.at;
  do
  {
    k = (k + step) % count;
    way.push_back(points[k]);
  } while (k != end.at);
}
}
