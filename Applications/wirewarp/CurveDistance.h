// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>

#include <vector>

namespace wirewarp
{
/// How far the points of the curves lie off the surface at most, in its unit: by so much they are
/// moved to be laid on it. Curves over the surface's own points lie on it.
double largestDistance(vtkPolyData* surface, const std::vector<vtkPolyData*>& curves);
}
