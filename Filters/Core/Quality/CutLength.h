// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Length of the cuts along which a surface has been opened: of its boundary edges that end at the
/// same places in space as another one, those of each place once.
double cutLength(const TriangleMesh& mesh);
}
