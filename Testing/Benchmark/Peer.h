// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace benchmarks
{
/// What a method that keeps no length makes of a disk.
struct PeerResult
{
  double seconds = 0.0; ///< of the parameterization alone, its mesh in memory
  flattening::Points2 positions;
};

/// CGAL's parameterizers, with the solvers that it chooses by itself.
PeerResult runConformalPeer(const flattening::TriangleMesh& mesh);
PeerResult runRigidPeer(const flattening::TriangleMesh& mesh);
}
