// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/ImprintedSurface.h"
#include "Suggestion/SeamSettling.h"
#include "Surface/TriangleMesh.h"

#include <optional>
#include <vector>

namespace flattening
{
/// A mesh with cut edges.
struct CutMesh
{
  TriangleMesh mesh;
  std::vector<char> cut; ///< by half-edge
  Indices images;        ///< by half-edge
};

/// The mesh cut along imprinted curves.
CutMesh cutAlong(const ImprintedSurface& imprinted);

/// Where a plane mirrors a surface.
MirrorSection sectionOf(const TriangleMesh& surface, const SymmetryPlane& plane);

/// The part of a surface on the positive side of the plane, whose section is laid into the surface
/// as edges. Empty where it cannot be. \param mirror whose distance becomes that of the edges
TriangleMesh halfOf(TriangleMesh& surface, MirrorSection& mirror);

/// With edges inside divided that join two points of the plane, at which four triangles of both
/// sides would meet. \param half of the surface on one side of the plane
CutMesh withoutBridges(CutMesh half, const std::optional<MirrorSection>& mirror);

/// By vertex of a half, its place on the other side of the surface: its mirror image where that is
/// exact; otherwise smoothly moved from there onto that side, next to points that face alike, and
/// from the boundary to the boundary. Vertices in the plane stay.
Points3 imagesOfHalf(
  const TriangleMesh& half, const TriangleMesh& surface, const MirrorSection& mirror);

/// Both sides of the plane together, cut along it as well. \pre withoutBridges()
/// \param images of the half's vertices; where there are none, mirrored ones
CutMesh bothSides(
  const CutMesh& half, const std::optional<MirrorSection>& mirror, const Points3& images = {});
}
