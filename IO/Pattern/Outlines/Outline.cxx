// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/Outline.h"

#include <cmath>

namespace flattening::pattern
{
namespace
{
double areaOf(const PatternSource& source, const Indices& loop)
{
  return doubleArea(positionsOf(source, loop));
}
}

Status invalidPieces(const std::string& message)
{
  return { StatusCode::InvalidPattern, message, {}, { Remedy::GiveFlatPieces } };
}

double doubleArea(const Points2& polygon)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    const Point2 a = polygon[k] - polygon.front();
    const Point2 b = polygon[(k + 1) % polygon.size()] - polygon.front();
    sum += cross(a, b);
  }
  return sum;
}

double lengthOnSurface(const PatternSource& source, Index a, Index b)
{
  return source.inSpace.empty() ? (source.positions[b] - source.positions[a]).norm()
                                : (source.inSpace[b] - source.inSpace[a]).norm();
}

std::vector<double> arcsOnSurface(const PatternSource& source, const Indices& wire)
{
  std::vector<double> arcs{ 0.0 };
  for (std::size_t k = 0; k + 1 < wire.size(); ++k)
  {
    arcs.push_back(arcs.back() + lengthOnSurface(source, wire[k], wire[k + 1]));
  }
  return arcs;
}

BorderEdges bordersOf(const PatternSource& source)
{
  BorderEdges borders;
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
  {
    const Triangle& corners = source.triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
    {
      borders[edgeKey(corners[k], corners[(k + 1) % 3])] = source.pieceOfTriangle[t];
    }
  }
  const BorderEdges all = borders;
  for (const auto& [edge, piece] : all)
  {
    borders.erase(edgeKey(endOf(edge), startOf(edge)));
  }
  return borders;
}

Index pieceOf(const BorderEdges& borders, Index from, Index to)
{
  auto found = borders.find(edgeKey(from, to));
  found = found != borders.end() ? found : borders.find(edgeKey(to, from));
  return found != borders.end() ? found->second : none;
}

bool areOnBorder(const BorderEdges& borders, const Indices& line)
{
  const auto isWithin = [&](Index from, Index to) { return pieceOf(borders, from, to) == none; };
  return std::adjacent_find(line.begin(), line.end(), isWithin) == line.end();
}

Triangles trianglesOf(const PatternSource& source, std::size_t piece)
{
  Triangles triangles;
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
  {
    if (source.pieceOfTriangle[t] == static_cast<Index>(piece))
    {
      triangles.push_back(source.triangles[t]);
    }
  }
  return triangles;
}

Points2 positionsOf(const PatternSource& source, const Indices& points)
{
  Points2 positions;
  for (const Index point : points)
  {
    positions.push_back(source.positions[static_cast<std::size_t>(point)]);
  }
  return positions;
}

std::size_t pieceCount(const PatternSource& source)
{
  const Indices& pieces = source.pieceOfTriangle;
  const auto last = std::max_element(pieces.begin(), pieces.end());
  return last == pieces.end() ? 0 : static_cast<std::size_t>(*last + 1);
}

Status findLoops(const PatternSource& source, const BorderEdges& borders, PieceLoops& loops)
{
  std::unordered_map<Index, Index> next;
  Indices starts; // in the order of the triangles, so that the result does not depend on hashing
  for (const Triangle& corners : source.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index from = corners[k];
      const Index to = corners[(k + 1) % 3];
      if (borders.count(edgeKey(from, to)) == 0)
      {
        continue;
      }
      if (!next.emplace(from, to).second)
      {
        return invalidPieces(
          "the boundary of the flat surface branches at point " + std::to_string(from));
      }
      starts.push_back(from);
    }
  }

  loops.assign(pieceCount(source), {});
  for (const Index start : starts)
  {
    auto at = next.find(start);
    if (at == next.end())
    {
      continue;
    }
    const std::size_t piece = static_cast<std::size_t>(borders.at(edgeKey(start, at->second)));
    Indices loop;
    Index end = start;
    while (at != next.end())
    {
      loop.push_back(at->first);
      end = at->second;
      next.erase(at);
      at = next.find(end);
    }
    if (end != start) // an edge has more than two triangles
    {
      return invalidPieces("the boundary of the flat surface ends at point " + std::to_string(end));
    }
    loops[piece].push_back(std::move(loop));
  }
  for (std::vector<Indices>& ofPiece : loops)
  {
    const auto outer =
      std::max_element(ofPiece.begin(), ofPiece.end(), [&](const Indices& a, const Indices& b) {
        return std::abs(areaOf(source, a)) < std::abs(areaOf(source, b));
      });
    if (outer != ofPiece.end())
    {
      std::iter_swap(ofPiece.begin(), outer);
    }
  }
  return {};
}

SewnPartners sewnPartners(const PatternSource& source)
{
  SewnPartners partners;
  for (const SewnEdges& pair : source.sewn)
  {
    partners[edgeKey(pair.a[0], pair.a[1])] = pair.b;
    partners[edgeKey(pair.a[1], pair.a[0])] = { pair.b[1], pair.b[0] };
    partners[edgeKey(pair.b[0], pair.b[1])] = pair.a;
    partners[edgeKey(pair.b[1], pair.b[0])] = { pair.a[1], pair.a[0] };
  }
  return partners;
}
}
