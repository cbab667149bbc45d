// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/DrawingSource.h"

#include <algorithm>
#include <optional>
#include <string>

namespace flattening::pattern
{
/// A border of a piece, closed, the cloth on the left; or a part of a feature curve within it.
struct BorderChain
{
  std::size_t piece = 0;
  bool closed = false;
  Indices points; ///< of a closed one the first not again
  std::vector<double>
    arc; ///< of the points, in the plane, millimetres; of a closed one also its length
  std::vector<bool> turns;  ///< whether the line has a corner at a point
  std::vector<bool> corner; ///< the same, and both ends of an open one, and ends of what is smooth

  std::vector<double> bends; ///< how far a smooth curve would be from a corner that it cannot keep
                             ///< near enough, millimetres; 0 at all other points

  std::size_t edges() const { return this->arc.size() - 1; }
  double length() const { return this->arc.back(); }
  Index point(std::size_t k) const { return this->points[k % this->points.size()]; }
  /// The edge at a place along it.
  std::size_t edgeAt(double place) const
  {
    const auto above = std::upper_bound(this->arc.begin(), this->arc.end(), place);
    return static_cast<std::size_t>(above - this->arc.begin()) - 1;
  }
  /// The place at a fraction of an edge.
  double arcWithin(std::size_t edge, double fraction) const
  {
    return this->arc[edge] + fraction * (this->arc[edge + 1] - this->arc[edge]);
  }
  /// The name of the curve that an edge is of, or "boundary".
  std::string nameOf(const DrawingSource& all, std::size_t edge) const
  {
    return all.nameAlong(this->point(edge), this->point(edge + 1));
  }
};

/// Where an edge lies.
struct ChainEdge
{
  std::size_t chain = 0;
  std::size_t edge = 0;
  bool backwards = false; ///< the chain runs from its second point to its first
};

/// All borders and feature curves of all pieces as chains, the borders first.
class BorderChains
{
public:
  explicit BorderChains(const DrawingSource& all);

  const std::vector<BorderChain>& chains() const { return this->Chains; }
  /// None where no chain has the edge.
  std::optional<ChainEdge> find(Index from, Index to) const;
  /// In how many chains a point is.
  std::size_t chainsAt(Index point) const;

private:
  void add(const DrawingSource& all, std::size_t piece, const Indices& points, bool closed);
  void addInnerCurves(const DrawingSource& all);
  void findCorners(const DrawingSource& all, BorderChain& chain);

  std::vector<BorderChain> Chains;
  std::unordered_map<std::uint64_t, std::array<std::size_t, 2>> Edges;
  std::unordered_map<Index, std::size_t> Count;
};
}
