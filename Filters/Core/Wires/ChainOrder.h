// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Wires/WireNetwork.h"

namespace flattening
{
/// Orders of elimination for matrices that couple neighbours along wires. Vertices and edges follow
/// each other along a wire by their numbers, so that each in turn leaves one neighbour only; what
/// is at a junction of wires goes last, and is left to LinearSolver to order.
struct ChainOrder
{
  explicit ChainOrder(const WireNetwork& network);

  Indices degree;     ///< per entry of hostVertices, how many edges are there
  Indices rankOfHost; ///< per entry of hostVertices
  Indices rankOfEdge;
  Index hostsAlong; ///< how many lie along wires and come first
  Index edgesAlong;
  std::vector<char> atJunction; ///< per edge, at one of its ends
};

/// Ranks of items in their order, those marked behind the others.
Indices markedLast(const std::vector<char>& marked);
}
