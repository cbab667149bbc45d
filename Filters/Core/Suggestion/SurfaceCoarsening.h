// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// A surface with fewer vertices, which are some of those before, where they were.
struct CoarseSurface
{
  TriangleMesh mesh;
  Indices vertices; ///< per vertex its id before
};

/// Moves vertices onto their nearest neighbours, those of the shortest edges first, so that edges
/// become equally long, until no more than `most` triangles are left or every step would fold the
/// surface, make a sliver or change its topology. All edges between kept vertices stay. \param kept
/// per vertex; those of the boundary are kept anyway
CoarseSurface coarsened(const TriangleMesh& mesh, std::vector<char> kept, Index most);
}
