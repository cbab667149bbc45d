// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Outline.h"

namespace flattening::pattern
{
/// A dart whose two legs lie on one boundary loop, mirror images of each other in the order of the
/// sewing.
struct Dart
{
  std::size_t loop = 0;      ///< of its piece
  std::size_t firstEdge = 0; ///< of the loop: the first leg runs from the mouth to the tip
  std::size_t edges = 0;     ///< of both legs
  Index tip = none;
  std::string name;
  std::array<Index, 2> mouth{ none, none }; ///< none: both ends are tips, the loop is the dart
  Index otherTip = none;                    ///< of a dart without mouth
};

/// Wire of each undirected edge (edgeKey of the smaller id first); a curve goes before the
/// boundary.
using WireOfEdge = std::unordered_map<std::uint64_t, std::size_t>;
WireOfEdge wiresOfEdges(const PatternSource& source);
/// \return its wire, or null
const SourceWire* wireOf(
  const PatternSource& source, const WireOfEdge& wires, Index from, Index to);

/// The darts of one piece that can be folded; any other cut is sewn like a seam.
std::vector<Dart> findDarts(const PatternSource& source, const std::vector<Indices>& loops,
  const WireOfEdge& wires, const SewnPartners& partners);

/// The corner of the cloth over the mouth of a dart, such that the folded dart ends at the sew line
/// of its neighbours: the mirror images of the neighbouring edges across their legs meet the fold
/// line there.
/// \param neighbour the boundary points next to the mouth, outside the dart
/// \param corner where there is one; a dart too wide or too thin for a roof is closed by a straight line
/// \return whether there is a corner
bool dartRoof(const Point2& tip, const std::array<Point2, 2>& mouth,
  const std::array<Point2, 2>& neighbour, Point2& corner);

/// How far the legs of a dart miss each other when it is folded: the largest distance of a point
/// from the mirror image of its partner. \param legs from mouth to tip and back to the mouth
double foldMiss(const Points2& legs);
}
