// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/ClosedCuts.h"

#include "Base/CompressedRows.h"
#include "Outlines/Outline.h"

#include <unordered_set>

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
    if (pair.closed)
    {
      sets.join(pair.a[0], pair.b[0]);
      sets.join(pair.a[1], pair.b[1]);
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
    if (pair.closed)
    {
      closed.insert(undirectedKey(pair.a[0], pair.a[1]));
      closed.insert(undirectedKey(pair.b[0], pair.b[1]));
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
  for (const SewnEdges& pair : source.sewn)
  {
    if (!pair.closed)
    {
      whole.sewn.push_back({ { joined[pair.a[0]], joined[pair.a[1]] },
        { joined[pair.b[0]], joined[pair.b[1]] }, false });
    }
  }
  whole.wires.clear();
  for (const SourceWire& wire : source.wires)
  {
    SourceWire part = wire;
    part.points.clear();
    const auto end = [&] {
      if (part.points.size() > 1)
      {
        whole.wires.push_back(part);
      }
      part.points.clear();
    };
    for (std::size_t k = 0; k < wire.points.size(); ++k)
    {
      if (k > 0 && closed.count(undirectedKey(wire.points[k - 1], wire.points[k])) > 0)
      {
        end();
      }
      part.points.push_back(joined[wire.points[k]]);
    }
    end();
  }
  return whole;
}
}
