// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/MirrorPlane.h"
#include "Surface/FeatureCurve.h"

namespace flattening
{
/// The closed lines in which a plane cuts a surface, as seams whose last point is the first again.
/// Lines that end at the boundary are left out.
std::vector<Polyline> sectionLoops(const TriangleMesh& mesh, const MirrorPlane& plane);
}
