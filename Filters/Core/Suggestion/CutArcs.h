// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

#include <vector>

namespace flattening
{
/// A seam or dart along edges, between places where cuts meet, or end, or reach the boundary.
struct CutArc
{
  Indices edges; ///< half-edges one after the other
  Indices vertices;
  bool dart = false; ///< the last vertex is a tip
  /// Whether no other meets it at its end, or at the hole there. Not told of opened arcs.
  bool frontFree = false;
  bool backFree = false;
};

/// All arcs of cut edges. \param cut per half-edge \param holeOf per vertex, see holesByVertex()
/// \param opened whether a closed one is two of half its edges each
std::vector<CutArc> cutArcs(
  const TriangleMesh& mesh, const std::vector<char>& cut, const Indices& holeOf, bool opened);
}
