// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

class vtkFeatureCurveEditor;

namespace editor
{
/// Of a key curve that is to be straight in the plane and cannot be, since it is closed or has a
/// corner at a node, what is wrong and what to do; empty where there is none. What the flattening
/// makes of it depends on how it runs between its nodes: clashing keys, flipped triangles, or a
/// piece bent beyond use.
std::string cornersOfStraightKeys(const vtkFeatureCurveEditor* curves);
}
