// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing.h"

#include <Eigen/Core>

namespace editor
{
/// Turns flat pieces so that they lie as they were shown before, and at first as their surface is
/// seen: where a filter lays them depends on their keys, and whoever looks at them would lose sight
/// of what he edits.
class SteadyPieces
{
public:
  /// Other pieces follow, of a surface that is seen with these directions to the right and up.
  void start(vtkPolyData* surface, const figures::Vector& right, const figures::Vector& up);
  /// Each piece turned by the rotation that fits its points best to where they were shown; several
  /// in rows beside each other, and the middle of all where it was.
  figures::FlatPiece settle(const figures::FlatPiece& piece);

private:
  Eigen::Matrix2Xd Shown; ///< a column for each point of the surface
};
}
