// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/Joins.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace flattening::pattern
{
namespace
{
using Side = std::array<Index, 2>; // an edge in the direction of its curve

/// Finds the bends of joins, of those with triangles in space on both sides.
void findBends(const PatternSource& source, std::vector<Join>& joins)
{
  std::unordered_map<std::uint64_t, std::size_t> triangleAt;
  for (std::size_t t = 0; t < source.triangles.size() && !source.inSpace.empty(); ++t)
  {
    const Triangle& corners = source.triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
    {
      triangleAt[edgeKey(corners[k], corners[(k + 1) % 3])] = t;
    }
  }
  const auto normal = [&source](std::size_t triangle) {
    const Triangle& corners = source.triangles[triangle];
    const Point3& x = source.inSpace[corners[0]];
    const Point3 across = (source.inSpace[corners[1]] - x).cross(source.inSpace[corners[2]] - x);
    return Point3(across.normalized());
  };
  for (Join& join : joins)
  {
    double sum = 0.0; // of angles, by the lengths of the edges
    double whole = 0.0;
    for (std::size_t k = 0; k + 1 < join.points[0].size(); ++k)
    {
      const Side one{ join.points[0][k], join.points[0][k + 1] };
      const Side other{ join.points[1][k], join.points[1][k + 1] };
      const auto here = triangleAt.find(edgeKey(one[0], one[1]));
      const bool forward = here != triangleAt.end();
      const auto first = forward ? here : triangleAt.find(edgeKey(one[1], one[0]));
      const auto second = forward ? triangleAt.find(edgeKey(other[1], other[0]))
                                  : triangleAt.find(edgeKey(other[0], other[1]));
      if (first == triangleAt.end() || second == triangleAt.end())
      {
        continue;
      }
      const Point3 way = (forward ? 1.0 : -1.0) * (source.inSpace[one[1]] - source.inSpace[one[0]]);
      const double length = way.norm();
      const Point3 a = normal(first->second);
      const Point3 b = normal(second->second);
      sum += length > 0.0 ? std::atan2(a.cross(b).dot(way / length), a.dot(b)) * length : 0.0;
      whole += length;
    }
    if (whole > 0.0)
    {
      join.bend = sum / whole;
    }
  }
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
      const auto ofPiece = [&border](const Side& side) {
        return static_cast<std::size_t>(std::max(pieceOf(border, side[0], side[1]), Index{ 0 }));
      };
      const std::array<std::size_t, 2> pieces{ ofPiece(one), ofPiece(other) };
      if (!going || joins.back().piece != pieces || joins.back().points[1].back() != other[0])
      {
        const bool isMarked = folded.count(undirectedKey(one[0], one[1])) == 0;
        joins.push_back({ isMarked ? joinMark(marked++) : "", w, k, arc[k], arc[k], pieces,
          { Indices{ one[0] }, Indices{ other[0] } } });
        going = true;
      }
      joins.back().to = arc[k + 1];
      joins.back().points[0].push_back(one[1]);
      joins.back().points[1].push_back(other[1]);
    }
  }
  findBends(source, joins);
  return joins;
}
}
