// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/BorderMarks.h"

#include "Fairing/FairBorders.h"

#include <map>
#include <set>

namespace flattening::pattern
{
namespace
{
struct CurveEnd
{
  std::string name;
  double arcLength = 0.0;
};

/// The ends of all curves but the boundary's, and the places that are sewn to them.
std::map<Index, CurveEnd> curveEnds(const PatternSource& source)
{
  std::map<Index, CurveEnd> ends;
  for (const SourceWire& wire : source.wires)
  {
    if (wire.type == WireType::Boundary || wire.points.size() < 2 ||
      wire.points.front() == wire.points.back())
    {
      continue;
    }
    ends.insert({ wire.points.front(), { wire.name, 0.0 } });
    ends.insert({ wire.points.back(), { wire.name, arcsOnSurface(source, wire.points).back() } });
  }
  const std::map<Index, CurveEnd> own = ends;
  for (const SewnEdges& pair : source.sewn)
  {
    for (std::size_t end = 0; end < 2; ++end)
    {
      for (const auto& [one, other] :
        { std::array{ pair.a[end], pair.b[end] }, std::array{ pair.b[end], pair.a[end] } })
      {
        const auto found = own.find(one);
        if (found != own.end())
        {
          ends.insert({ other, found->second });
        }
      }
    }
  }
  return ends;
}
}

std::vector<BorderMark> findBorderMarks(const DrawingSource& all)
{
  std::vector<BorderMark> marks;
  if (!all.options.notchCorners && !all.options.notchCurveEnds)
  {
    return marks;
  }
  const std::map<Index, CurveEnd> ends = curveEnds(all.source);
  std::set<Index> ofDarts;
  std::size_t borders = 0; // the first of the chains
  for (std::size_t p = 0; p < all.loops.size(); ++p)
  {
    borders += all.loops[p].size();
    for (const Dart& dart : all.darts[p])
    {
      ofDarts.insert({ dart.tip, dart.otherTip, dart.mouth[0], dart.mouth[1] });
    }
  }
  const BorderChains chains(all);
  for (std::size_t c = 0; c < borders; ++c)
  {
    const BorderChain& chain = chains.chains()[c];
    const std::size_t count = chain.points.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      const Index point = chain.points[k];
      const bool corner = chain.turns[k];
      const auto end = ends.find(point);
      const bool isWanted =
        corner ? all.options.notchCorners : all.options.notchCurveEnds && end != ends.end();
      if (isWanted && ofDarts.count(point) == 0)
      {
        const CurveEnd there = end == ends.end() ? CurveEnd() : end->second;
        marks.push_back({ chain.piece, chain.point(k + count - 1), point, chain.point(k + 1),
          corner, there.name, there.arcLength });
      }
    }
  }
  return marks;
}
}
