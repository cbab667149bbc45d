// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// The unit normal of each vertex by the angles of its triangles, of length 0 where it has none
/// (J. A. Baerentzen, H. Aanaes, "Signed distance computation using the angle weighted
/// pseudonormal", 2005).
Points3 vertexNormals(const TriangleMesh& mesh);
}
