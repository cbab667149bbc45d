// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/PatternSource.h"

#include <algorithm>
#include <unordered_map>

namespace flattening::pattern
{
/// InvalidPattern with the remedy to give the outputs of one flattening.
Status invalidPieces(const std::string& message);

/// Directed edges as keys of a hash map.
inline std::uint64_t edgeKey(Index from, Index to)
{
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32) |
    static_cast<std::uint32_t>(to);
}
inline Index startOf(std::uint64_t edge)
{
  return static_cast<Index>(edge >> 32);
}
inline Index endOf(std::uint64_t edge)
{
  return static_cast<Index>(static_cast<std::uint32_t>(edge));
}
/// The same for both directions.
inline std::uint64_t undirectedKey(Index a, Index b)
{
  return edgeKey(std::min(a, b), std::max(a, b));
}

/// Boundary loops of each piece as point ids, the cloth on the left; the outer loop first, that is
/// the one that encloses the largest area.
using PieceLoops = std::vector<std::vector<Indices>>;

/// Directed edges of borders, the cloth on the left, with their pieces.
using BorderEdges = std::unordered_map<std::uint64_t, Index>;
BorderEdges bordersOf(const PatternSource& source);
/// The piece of an edge of a border, in either direction; none of another edge.
Index pieceOf(const BorderEdges& borders, Index from, Index to);
/// Whether all edges of a line are of borders.
bool areOnBorder(const BorderEdges& borders, const Indices& line);

/// The triangles of a piece.
Triangles trianglesOf(const PatternSource& source, std::size_t piece);

/// Where points lie in the plane.
Points2 positionsOf(const PatternSource& source, const Indices& points);

/// How many pieces a source has.
std::size_t pieceCount(const PatternSource& source);

/// \return InvalidInput where the boundary of a piece does not fall into loops.
Status findLoops(const PatternSource& source, const BorderEdges& borders, PieceLoops& loops);

/// Which points an edge is sewn to: the directed edge (a, b) to its partner, in the same direction
/// of the curve. Both banks are keys, in both directions.
using SewnPartners = std::unordered_map<std::uint64_t, std::array<Index, 2>>;
SewnPartners sewnPartners(const PatternSource& source);

/// Of an edge on the surface; in the plane where its points in space are not known.
double lengthOnSurface(const PatternSource& source, Index a, Index b);

/// Of the points of a wire, along it from its first one.
std::vector<double> arcsOnSurface(const PatternSource& source, const Indices& wire);

/// Twice the signed area of a closed polygon.
double doubleArea(const Points2& polygon);
}
