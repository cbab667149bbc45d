// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/Joins.h"

#include <string_view>
#include <unordered_set>

namespace flattening::pattern
{
namespace
{
using Side = std::array<Index, 2>; // an edge in the direction of its curve

std::size_t pieceOf(const BorderEdges& border, const Side& side)
{
  auto found = border.find(edgeKey(side[0], side[1]));
  found = found != border.end() ? found : border.find(edgeKey(side[1], side[0]));
  return found != border.end() ? static_cast<std::size_t>(found->second) : 0;
}

/// The legs of folded darts.
std::unordered_set<std::uint64_t> foldedEdges(
  const PieceLoops& loops, const std::vector<std::vector<Dart>>& darts)
{
  std::unordered_set<std::uint64_t> folded;
  for (std::size_t p = 0; p < darts.size(); ++p)
  {
    for (const Dart& dart : darts[p])
    {
      const Indices& loop = loops[p][dart.loop];
      for (std::size_t k = dart.firstEdge; k < dart.firstEdge + dart.edges; ++k)
      {
        folded.insert(undirectedKey(loop[k % loop.size()], loop[(k + 1) % loop.size()]));
      }
    }
  }
  return folded;
}
}

std::string joinMark(std::size_t number)
{
  constexpr std::string_view letters = "ABCDEFGHJKLMNPQRSTUVWXYZ";
  std::string mark;
  for (std::size_t rest = number + 1; rest > 0; rest = (rest - 1) / letters.size())
  {
    mark.insert(mark.begin(), letters[(rest - 1) % letters.size()]);
  }
  return mark;
}

std::vector<Join> findJoins(const PatternSource& source, const BorderEdges& border,
  const SewnPartners& partners, const PieceLoops& loops,
  const std::vector<std::vector<Dart>>& darts)
{
  const std::unordered_set<std::uint64_t> folded = foldedEdges(loops, darts);
  std::vector<Join> joins;
  std::unordered_set<std::uint64_t> done; // edges of both sides
  std::size_t marked = 0;
  for (std::size_t w = 0; w < source.wires.size(); ++w)
  {
    const SourceWire& wire = source.wires[w];
    if (wire.type != WireType::Seam && wire.type != WireType::Dart)
    {
      continue;
    }
    const std::vector<double> arc = arcsOnSurface(source, wire.points);
    bool going = false;
    for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
    {
      const Side one{ wire.points[k], wire.points[k + 1] };
      const auto partner = partners.find(edgeKey(one[0], one[1]));
      if (partner == partners.end() || !done.insert(undirectedKey(one[0], one[1])).second)
      {
        going = false;
        continue;
      }
      const Side& other = partner->second;
      done.insert(undirectedKey(other[0], other[1]));
      const std::array<std::size_t, 2> pieces{ pieceOf(border, one), pieceOf(border, other) };
      if (!going || joins.back().piece != pieces || joins.back().points[1].back() != other[0])
      {
        Join& join = joins.emplace_back();
        const bool isMarked = folded.count(undirectedKey(one[0], one[1])) == 0;
        join.mark = isMarked ? joinMark(marked++) : "";
        join.wire = w;
        join.firstEdge = k;
        join.from = arc[k];
        join.piece = pieces;
        join.points = { Indices{ one[0] }, Indices{ other[0] } };
        going = true;
      }
      joins.back().to = arc[k + 1];
      joins.back().points[0].push_back(one[1]);
      joins.back().points[1].push_back(other[1]);
    }
  }
  return joins;
}
}
