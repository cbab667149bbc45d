// SPDX-License-Identifier: BSD-3-Clause
#include "Notches.h"

#include <cmath>
#include <unordered_set>

namespace flattening
{
namespace pattern
{
namespace
{
double lengthOf(const PatternSource& source, Index a, Index b)
{
  return source.inSpace.empty() ? (source.positions[b] - source.positions[a]).norm()
                                : (source.inSpace[b] - source.inSpace[a]).norm();
}

std::vector<double> stations(double length, double spacing)
{
  std::vector<double> at;
  // The last one keeps some distance from the end, which is a mark of its own.
  for (int k = 1; k * spacing < length - 0.25 * spacing; ++k)
  {
    at.push_back(k * spacing);
  }
  if (at.empty())
  {
    at.push_back(length / 2.0);
  }
  return at;
}

/// Turns a place so that its edge has the cloth on its left.
NotchPlace onBoundary(const std::unordered_set<std::uint64_t>& boundary, NotchPlace place)
{
  if (boundary.count(edgeKey(place.edge[0], place.edge[1])) == 0)
  {
    std::swap(place.edge[0], place.edge[1]);
    place.fraction = 1.0 - place.fraction;
  }
  return place;
}
}

PatternStatus placeNotches(const PatternSource& source, const PieceLoops& loops,
  const SewnPartners& partners, double spacing, std::vector<NotchPlace>& places)
{
  places.clear();
  if (!(spacing > 0.0))
  {
    return {};
  }
  std::unordered_set<std::uint64_t> boundary;
  for (const auto& ofPiece : loops)
  {
    for (const Indices& loop : ofPiece)
    {
      for (std::size_t k = 0; k < loop.size(); ++k)
      {
        boundary.insert(edgeKey(loop[k], loop[(k + 1) % loop.size()]));
      }
    }
  }
  std::unordered_set<std::uint64_t> done; // edges whose partners have been walked
  for (std::size_t w = 0; w < source.wires.size(); ++w)
  {
    const SourceWire& wire = source.wires[w];
    if (wire.type != WireType::Seam && wire.type != WireType::Dart)
    {
      continue;
    }
    std::vector<double> arc{ 0.0 };
    for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
    {
      arc.push_back(arc.back() + lengthOf(source, wire.points[k], wire.points[k + 1]));
    }
    if (!(arc.back() / spacing < 10000.0))
    {
      return { PatternCode::InvalidOption,
        "notches so close give more than 10000 of them on the curve " + wire.name +
          "; check the unit, or take a larger notch spacing" };
    }
    const std::vector<double> at = stations(arc.back(), spacing);
    std::size_t next = 0;
    for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
    {
      const Index from = wire.points[k];
      const Index to = wire.points[k + 1];
      const auto partner = partners.find(edgeKey(from, to));
      const bool walked =
        partner == partners.end() || done.count(edgeKey(from, to)) > 0 || arc[k + 1] <= arc[k];
      for (; next < at.size() && at[next] <= arc[k + 1]; ++next)
      {
        if (walked)
        {
          continue;
        }
        const double fraction = (at[next] - arc[k]) / (arc[k + 1] - arc[k]);
        places.push_back(onBoundary(boundary, { { from, to }, fraction, at[next], w }));
        places.push_back(onBoundary(boundary, { partner->second, fraction, at[next], w }));
      }
      if (partner != partners.end())
      {
        done.insert(edgeKey(partner->second[0], partner->second[1]));
      }
    }
  }
  return {};
}
}
}
