// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Length of the cuts along which a surface has been opened: of its boundary edges that end at the
/// same places in space as another one, those of each place once.
double cutLength(const TriangleMesh& mesh);

/// E_dev of Eq. 25, in radians: size of the angle defect, 2 pi less the sum of the angles around
/// each interior vertex; 0 on the boundary, where any sum can lie flat.
/// \param angles TriangleMesh::angle() of each half-edge.
std::vector<double> surfaceDevelopability(
  const TriangleMesh& mesh, const std::vector<double>& angles);

/// TriangleMesh::angle() of each half-edge, in radians.
std::vector<double> cornerAngles(const TriangleMesh& mesh, const Execution& execution);
}
