// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Some triangles of a mesh as a mesh of their own.
struct OpenedPart
{
  TriangleMesh mesh;
  Indices vertices; ///< per vertex its id in the mesh before
};

/// By vertex the boundary loop that it is on, where that is a hole; else none.
Indices holesByVertex(
  const TriangleMesh& mesh, const std::vector<Indices>& loops, const std::vector<char>& holes);

/// \param cut per half-edge of the mesh, whether it is open; both sides agree
OpenedPart openedPart(
  const TriangleMesh& mesh, const Indices& triangles, const std::vector<char>& cut);

/// The strain, on 95 % of the area, that a piece keeps when it is scaled to be flat with its
/// boundary's lengths: of the log scale factor u with L u = K inside and u = 0 on the boundary, as
/// in ScaleFactor. Infinity where the system cannot be solved.
double forecastStrain(const TriangleMesh& piece);

/// Parts a surface into disks that are nearly developable: triangles are merged into clusters, and
/// clusters into larger ones, those first whose normals lie nearest to a circle of the Gauss
/// sphere, as those of planes, cones and cylinders do, and whose outline is short (M. Garland, A.
/// Willmott, P. Heckbert, "Hierarchical face clustering on polygonal surfaces", 2001; the proxies
/// of D. Julius, V. Kraevoy, A. Sheffer, "D-Charts: quasi-developable mesh segmentation", 2005), as
/// long as forecastStrain() stays within a bound. No cluster goes across a sharp edge.
/// \param holes per boundary loop of the mesh, whether a cluster may surround it
/// \return per triangle its cluster
Indices clusterTriangles(const TriangleMesh& mesh, const std::vector<Indices>& loops,
  const std::vector<char>& holes, double bound);

/// The two sides of a mesh across its longest axis.
Indices halvesOf(const TriangleMesh& mesh);
}
