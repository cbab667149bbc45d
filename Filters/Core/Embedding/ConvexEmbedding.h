// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Positions by vertex of a disk, or of one with holes, without a folded triangle, whatever its
/// shape: the longest boundary on a circle of its length, each other vertex in the middle of its
/// neighbours by positive weights (W. T. Tutte, "How to draw a graph", Proceedings of the London
/// Mathematical Society 13, 1963; M. S. Floater, "Parametrization and smooth approximation of
/// surface triangulations", CAGD 14(3), 1997). Weights are the cotangents where they are positive,
/// so that angles change little where the surface allows it; where triangles would be lost to
/// rounding, as along a tube, weights fall along the surface. A hole is spanned by a vertex.
/// \return nothing where the system cannot be solved or the run was cancelled.
Points2 embedConvexly(const TriangleMesh& mesh, const Execution& execution);
}
