// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/Notches.h"

#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

namespace flattening::pattern
{
namespace
{
/// Lengths from the start of a stretch at which it is notched: multiples of the spacing, up to a
/// quarter of it before the end, or the middle where there is none of these.
/// \param directed the first one moves towards the start, by a quarter of the spacing or a tenth of
/// the length, where the notches would otherwise be the same from either end
std::vector<double> notchStations(double length, double spacing, bool directed)
{
  std::vector<double> stations;
  // The last one keeps some distance from the end, which is a mark of its own.
  for (int k = 1; k * spacing < length - 0.25 * spacing; ++k)
  {
    stations.push_back(k * spacing);
  }
  if (stations.empty())
  {
    stations.push_back(length / 2.0);
  }
  const double left = length - stations.back();
  if (directed && std::abs(stations.front() - left) < 0.1 * std::min(spacing, length))
  {
    stations.front() -= std::min(0.25 * spacing, 0.1 * length);
  }
  return stations;
}

/// \param length of the wire \param scale millimetres per unit of the lengths
Status stationsOf(const PatternSource& source, std::size_t wire, double length,
  const std::vector<Join>& joins, const PatternOptions& options, double scale,
  std::vector<double>& stations)
{
  const std::string& name = source.wires[wire].name;
  const auto own = options.notchesOfCurve.find(name);
  if (own != options.notchesOfCurve.end())
  {
    for (const double distance : own->second)
    {
      // The ends are marks of their own.
      if (distance > 0.0 && distance / scale < length)
      {
        stations.push_back(distance / scale);
      }
    }
    sortUnique(stations);
    return {};
  }
  const double spacing = options.notchSpacing / scale;
  for (const Join& join : joins)
  {
    if (join.wire != wire || !(spacing > 0.0))
    {
      continue;
    }
    const double joined = join.to - join.from;
    if (!(joined / spacing < 10000.0))
    {
      return { StatusCode::InvalidOption,
        "notches so close give more than 10000 of them on the curve " + name, {},
        { Remedy::CheckUnit, Remedy::WidenNotches } };
    }
    for (const double at :
      notchStations(joined, spacing, source.wires[wire].type == WireType::Seam))
    {
      stations.push_back(join.from + at);
    }
  }
  return {};
}

/// Turns a place so that its edge has the cloth on its left.
NotchPlace onBoundary(const BorderEdges& boundary, NotchPlace place)
{
  if (boundary.count(edgeKey(place.edge[0], place.edge[1])) == 0)
  {
    std::swap(place.edge[0], place.edge[1]);
    place.fraction = 1.0 - place.fraction;
  }
  return place;
}

/// What the stations of a wire become, in their order along it; their edges are not known.
std::vector<NotchPlace> marksOf(
  const std::vector<double>& stations, std::size_t wire, bool twice, double half, double length)
{
  std::vector<NotchPlace> marks;
  const auto add = [&](double at, bool isDrawn, bool isStop) {
    marks.push_back({ { none, none }, 0.0, at, wire, isDrawn, isStop });
  };
  for (const double at : stations)
  {
    add(at, !twice, true);
    if (twice)
    {
      add(std::max(at - half, 0.0), true, false);
      add(std::min(at + half, length), true, false);
    }
  }
  std::stable_sort(marks.begin(), marks.end(),
    [](const NotchPlace& a, const NotchPlace& b) { return a.arcLength < b.arcLength; });
  return marks;
}
}

Status placeNotches(const PatternSource& source, const BorderEdges& border,
  const SewnPartners& partners, const std::vector<Join>& joins, const PatternOptions& options,
  std::vector<std::vector<double>>& stations, std::vector<NotchPlace>& places)
{
  stations.assign(source.wires.size(), {});
  places.clear();
  const double scale = millimetresPer(options.unit);
  std::map<std::string, double> longest;  // wires that have notches of their own
  std::unordered_set<std::uint64_t> done; // edges whose partners have been walked
  for (std::size_t w = 0; w < source.wires.size(); ++w)
  {
    const SourceWire& wire = source.wires[w];
    const std::vector<double> arc = arcsOnSurface(source, wire.points);
    if (options.notchesOfCurve.count(wire.name) > 0)
    {
      longest[wire.name] = std::max(longest[wire.name], scale * arc.back());
    }
    if (Status status = stationsOf(source, w, arc.back(), joins, options, scale, stations[w]);
        !status.ok())
    {
      return status;
    }
    const std::vector<NotchPlace> marks = marksOf(stations[w], w,
      options.doubleNotches.count(wire.name) > 0, doubleNotchDistance / 2.0 / scale, arc.back());
    std::size_t next = 0;
    for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
    {
      const Index from = wire.points[k];
      const Index to = wire.points[k + 1];
      const auto partner = partners.find(edgeKey(from, to));
      const bool sewn = partner != partners.end();
      const bool isBorder = pieceOf(border, from, to) != none;
      const bool walked = !isBorder || done.count(edgeKey(from, to)) > 0 || arc[k + 1] <= arc[k];
      for (; next < marks.size() && marks[next].arcLength <= arc[k + 1]; ++next)
      {
        if (walked)
        {
          continue;
        }
        NotchPlace mark = marks[next];
        mark.fraction = (mark.arcLength - arc[k]) / (arc[k + 1] - arc[k]);
        mark.edge = { from, to };
        places.push_back(onBoundary(border, mark));
        if (sewn)
        {
          mark.edge = partner->second;
          places.push_back(onBoundary(border, mark));
        }
      }
      if (sewn)
      {
        done.insert(edgeKey(partner->second[0], partner->second[1]));
      }
    }
  }
  for (const auto& [name, length] : longest)
  {
    const std::vector<double>& wanted = options.notchesOfCurve.at(name);
    const auto farthest = std::max_element(wanted.begin(), wanted.end());
    if (farthest != wanted.end() && *farthest > length)
    {
      return { StatusCode::InvalidOption,
        "a notch is to be " + formatNumber(*farthest, 1) + " mm along the curve " + name +
          ", which is " + formatNumber(length, 1) + " mm long",
        {}, { Remedy::CheckUnit, { Remedy::Give, "a distance within the curve" } } };
    }
  }
  return {};
}
}
