// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Shares vertices among at most so many seeds that lie far from each other: each next seed is the
/// vertex farthest, along edges, from those before, and a vertex goes to the nearest seed. Every
/// vertex is a cluster of its own where there are no more.
/// \param members vertices to share, ascending; paths run through them alone.
/// \return per vertex its cluster, none for others than members
Indices clusterVertices(const TriangleMesh& mesh, const Indices& members, Index most);
}
