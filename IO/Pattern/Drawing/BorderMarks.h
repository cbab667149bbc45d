// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/DrawingSource.h"

namespace flattening::pattern
{
/// A place of a border that wants a notch whether or not it is sewn.
struct BorderMark
{
  std::size_t piece = 0;
  Index before = none; ///< the border's points around it
  Index point = none;
  Index after = none;
  bool corner = false;    ///< of the border; otherwise a curve meets it there
  std::string name;       ///< of that curve
  double arcLength = 0.0; ///< of the place along it, on the surface, in the unit of the surface
};

/// Corners, where the options ask for them, and where curves meet a border within its run: the ends
/// of feature curves, and the ends of seams and curves of the piece that is sewn to it there. Tips
/// and mouths of darts are neither: they have marks of their own.
std::vector<BorderMark> findBorderMarks(const DrawingSource& all);
}
