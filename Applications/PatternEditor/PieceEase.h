// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace editor
{
/// By how much a curve is longer in one piece than on the surface, as vtkFeatureCurveEditor has it.
struct PieceEase
{
  double fraction = 0.0; ///< 0: no ease
  int piece = -1;        ///< from 0; -1: the only one that it is in
};

using PieceEases = std::map<std::string, PieceEase>; ///< by name
}
