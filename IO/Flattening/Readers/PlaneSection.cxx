// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneSection.h"

#include "TextFile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace wirewarp
{
namespace
{
using Place = Point3;
using Edge = std::pair<std::int64_t, std::int64_t>;

double distanceOf(const Place& a, const Place& b)
{
  return (a - b).norm();
}

double lengthOf(const SectionLine& line)
{
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
  {
    length += distanceOf(line[k], line[k + 1]);
  }
  return length;
}

class Section
{
public:
  Section(const TriangleList& list, const SectionPlane& plane)
    : List(list)
    , Plane(plane)
  {
    for (const ListedTriangle& triangle : list.triangles)
    {
      this->cut(triangle);
    }
  }

  std::vector<SectionLine> lines()
  {
    std::vector<SectionLine> all;
    // Lines with ends before those without.
    for (const bool open : { true, false })
    {
      for (const auto& [edge, neighbors] : this->Neighbors)
      {
        if (!open || neighbors.size() == 1)
        {
          this->follow(edge, all);
        }
      }
    }
    std::stable_sort(all.begin(), all.end(),
      [](const SectionLine& a, const SectionLine& b) { return lengthOf(a) > lengthOf(b); });
    return all;
  }

private:
  const Place& placeOf(std::int64_t point) const { return this->List.point(point); }

  bool isAbove(std::int64_t point) const
  {
    return this->placeOf(point)[static_cast<Eigen::Index>(this->Plane.axis)] >= this->Plane.place;
  }

  /// Where an edge between both sides meets the plane.
  Place placeOf(const Edge& edge) const
  {
    const Place& a = this->placeOf(edge.first);
    const Place& b = this->placeOf(edge.second);
    const auto axis = static_cast<Eigen::Index>(this->Plane.axis);
    const double s = (this->Plane.place - a[axis]) / (b[axis] - a[axis]);
    Place x = a + s * (b - a);
    x[axis] = this->Plane.place;
    return x;
  }

  bool isWithin(const Place& a, const Place& b) const
  {
    return std::all_of(
      this->Plane.bounds.begin(), this->Plane.bounds.end(), [&](const SectionPlane::Bound& bound) {
        const auto axis = static_cast<Eigen::Index>(bound.axis);
        const double middle = (a[axis] + b[axis]) / 2.0;
        return bound.above ? middle > bound.place : middle < bound.place;
      });
  }

  void cut(const ListedTriangle& triangle)
  {
    std::vector<Edge> crossed;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int64_t a = triangle.corners[k];
      const std::int64_t b = triangle.corners[(k + 1) % 3];
      if (this->isAbove(a) != this->isAbove(b))
      {
        crossed.emplace_back(std::minmax(a, b));
      }
    }
    if (crossed.size() == 2 && this->isWithin(this->placeOf(crossed[0]), this->placeOf(crossed[1])))
    {
      this->Neighbors[crossed[0]].push_back(crossed[1]);
      this->Neighbors[crossed[1]].push_back(crossed[0]);
    }
  }

  /// Takes a line from one of its edges on.
  void follow(const Edge& first, std::vector<SectionLine>& all)
  {
    SectionLine line;
    Edge at = first;
    for (;;)
    {
      const Place next = this->placeOf(at);
      if (line.empty() || distanceOf(line.back(), next) > 0.0)
      {
        line.push_back(next); // through a vertex several edges lead
      }
      std::vector<Edge>& onwards = this->Neighbors.at(at);
      if (onwards.empty())
      {
        break;
      }
      const Edge to = onwards.front();
      onwards.erase(onwards.begin());
      std::vector<Edge>& back = this->Neighbors.at(to);
      back.erase(std::find(back.begin(), back.end(), at));
      at = to;
    }
    if (line.size() > 1)
    {
      all.push_back(std::move(line));
    }
  }

  const TriangleList& List;
  const SectionPlane& Plane;
  std::map<Edge, std::vector<Edge>> Neighbors; ///< of edges that are crossed, in triangles
};
}

std::optional<SectionPlane> sectionPlaneOf(std::string_view words)
{
  constexpr std::string_view axes = "xyz";
  SectionPlane plane;
  bool first = true;
  for (std::string_view word = takeWord(words); !word.empty(); word = takeWord(words))
  {
    const std::size_t axis = axes.find(word.front());
    const char sign = word.size() > 1 ? word[1] : ' ';
    double place = 0.0;
    if (axis == std::string_view::npos ||
      !parseNumber(word.substr(std::min<std::size_t>(2, word.size())), place) ||
      !std::isfinite(place) || (first ? sign != '=' : sign != '<' && sign != '>'))
    {
      return std::nullopt;
    }
    if (first)
    {
      plane.axis = axis;
      plane.place = place;
    }
    else
    {
      plane.bounds.push_back({ axis, place, sign == '>' });
    }
    first = false;
  }
  return first ? std::nullopt : std::optional(plane);
}

std::vector<SectionLine> sectionOf(const TriangleList& list, const SectionPlane& plane)
{
  return Section(list, plane).lines();
}
}
