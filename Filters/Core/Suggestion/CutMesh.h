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

/// With edges inside divided that join two points of the plane, at which four triangles of both
/// sides would meet. \param half of the surface on one side of the plane
CutMesh withoutBridges(CutMesh half, const std::optional<MirrorSection>& mirror);

/// Both sides of the plane together, cut along it as well. \pre withoutBridges()
CutMesh bothSides(const CutMesh& half, const std::optional<MirrorSection>& mirror);
}
