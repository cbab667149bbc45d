// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairBorders.h"

namespace flattening::pattern
{
/// One of the curves and straight lines that the outer border of a piece is made of.
struct BorderEdge
{
  FairSpan curve;
  std::string name;                        ///< of its feature curve; empty on the boundary
  std::size_t sewn[2]{ nowhere, nowhere }; ///< piece and edge that it is sewn to, whole to whole

  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
};

/// The outer borders of all pieces, counter-clockwise. What is sewn is divided alike on both sides,
/// so that edges are sewn to edges.
std::vector<std::vector<BorderEdge>> borderEdges(const DrawingSource& all, const FairBorders& fair);
}
