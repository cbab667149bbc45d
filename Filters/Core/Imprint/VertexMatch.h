// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Per query the nearest vertex within the radius, with all others at the same place; ascending
/// ids.
///
/// One pass over the vertices against a hashed grid of the queries: a few curves on a large mesh
/// cost no search structure over the mesh. Vertices that no triangle uses are left out.
std::vector<Indices> matchVertices(const TriangleMesh& mesh, const Points3& queries, double radius);

/// One vertex per point of a polyline, none where it has no candidate. Where points of the mesh
/// coincide without being joined, as on the two sides of an open slit, the curve stays on its side:
/// as many steps as possible are edges; then the smaller ids win.
Indices chooseVertices(const TriangleMesh& mesh, const std::vector<Indices>& candidates);
}
