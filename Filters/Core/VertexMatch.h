// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TriangleMesh.h"

namespace flattening
{
/// Per query the nearest vertex (the smallest id among equals) within the radius, otherwise none.
///
/// One pass over the vertices against a hashed grid of the queries: a few curves on a large mesh
/// cost no search structure over the mesh. Vertices that no triangle uses are left out.
Indices matchVertices(const TriangleMesh& mesh, const Points3& queries, double radius);
}
