// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace editor
{
/// By how much a curve is longer in one piece than on the surface, as vtkWireWarpingFilter has it.
struct PieceEase
{
  double fraction = 0.0;
  int piece = -1; ///< from 0; -1: the only one that it is in

  bool operator==(const PieceEase& other) const
  {
    return this->fraction == other.fraction && this->piece == other.piece;
  }
};

using PieceEases = std::map<std::string, PieceEase>; ///< by name
}
