// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/ClosedCuts.h"

#include "Base/CompressedRows.h"
#include "Outlines/Outline.h"

#include <array>
#include <unordered_set>
#include <utility>

namespace flattening::pattern
{
namespace
{
/// The point that each becomes.
Indices joinedPoints(const PatternSource& source)
{
  JoinedSets sets(static_cast<Index>(source.positions.size()));
  for (const SewnEdges& pair : source.sewn)
  {
    for (std::size_t end = 0; pair.closed && end < 2; ++end)
    {
      sets.join(pair.a[end], pair.b[end]);
    }
  }
  Indices joined;
  for (std::size_t v = 0; v < source.positions.size(); ++v)
  {
    joined.push_back(sets.find(static_cast<Index>(v)));
  }
  return joined;
}

/// Both banks of closed edges.
std::unordered_set<std::uint64_t> closedEdges(const PatternSource& source)
{
  std::unordered_set<std::uint64_t> closed;
  for (const SewnEdges& pair : source.sewn)
  {
    for (const std::array<Index, 2>& edge : { pair.a, pair.b })
    {
      if (pair.closed)
      {
        closed.insert(undirectedKey(edge[0], edge[1]));
      }
    }
  }
  return closed;
}
}

PatternSource withoutClosedCuts(const PatternSource& source)
{
  PatternSource whole = source;
  const Indices joined = joinedPoints(source);
  const std::unordered_set<std::uint64_t> closed = closedEdges(source);
  for (Triangle& corners : whole.triangles)
  {
    for (Index& v : corners)
    {
      v = joined[v];
    }
  }
  for (Index& v : whole.gradePoints)
  {
    v = joined[v];
  }
  whole.sewn.clear();
  for (SewnEdges pair : source.sewn)
  {
    for (std::size_t end = 0; end < 2; ++end)
    {
      pair.a[end] = joined[pair.a[end]];
      pair.b[end] = joined[pair.b[end]];
    }
    if (!pair.closed)
    {
      whole.sewn.push_back(pair);
    }
  }
  whole.wires.clear();
  for (const SourceWire& wire : source.wires)
  {
    SourceWire part = wire;
    part.points.clear();
    for (std::size_t k = 0; k < wire.points.size(); ++k)
    {
      if (k > 0 && closed.count(undirectedKey(wire.points[k - 1], wire.points[k])) > 0)
      {
        if (part.points.size() > 1)
        {
          whole.wires.push_back(part);
        }
        part.points.clear();
      }
      part.points.push_back(joined[wire.points[k]]);
    }
    if (part.points.size() > 1)
    {
      whole.wires.push_back(std::move(part));
    }
  }
  return whole;
}
}
