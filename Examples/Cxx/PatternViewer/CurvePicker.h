// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PatternModel.h"

#include <vtkRenderer.h>

namespace viewer
{
/// The curve that is drawn nearest to a place in the window, -1 where none is within reach. Of the
/// curves in space, what the surface hides cannot be picked.
int pickCurve(
  const PatternModel& model, vtkRenderer* renderer, bool inPlane, const std::array<int, 2>& place);
}
