// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/DataSet.h"

namespace wirewarp
{
/// The layer of a sheet that keeps its lengths while it is bent: the surface, whose normals point
/// outwards, moved inwards by a distance in its unit; below 0 outwards. Points keep their ids, and
/// planes move by the distance exactly, also at edges.
flattening::DataSet neutralLayer(const flattening::DataSet& surface, double inwards);
}
