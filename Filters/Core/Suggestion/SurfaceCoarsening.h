// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CurveSuggestions.h"
#include "Suggestion/SurfaceMirror.h"
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

/// A version with few triangles; boundaries and creases stay.
TriangleMesh fewTriangles(const TriangleMesh& mesh, Index most);

/// A version of a large surface on which its cuts are found. None where the surface is small
/// enough itself, or hardly any vertex may go, as in a ribbon, whose are all on the boundary.
std::optional<TriangleMesh> coarseVersion(const TriangleMesh& mesh);

/// The cuts of a version with fewer triangles on the surface itself, as laidTogether() leaves them.
/// \param mirror of that version, then of the surface
std::vector<SuggestedCurve> movedCuts(
  const TriangleMesh& mesh, std::optional<SurfaceMirror>& mirror, std::vector<SuggestedCurve> cuts);
}
