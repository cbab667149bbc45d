// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <optional>
#include <string>
#include <vector>

namespace wirewarp
{
/// What is done to a surface on request before it is healed and flattened.
struct MendingRequest
{
  /// Join points of the boundary up to this distance apart, in mm; 0: those that coincide.
  std::optional<double> weld = std::nullopt;
  bool doubled = false;     ///< the same, because the file's format doubles points
  bool likely = false;      ///< the same where most of the boundary lies on itself
  double fillHoles = 0.0;   ///< close openings up to so many millimetres across
  double millimetres = 1.0; ///< of the unit of the surface
  bool outerSide = false;   ///< of sheets with thickness and of two-sided faces take one side
  bool likelySide = false;  ///< the same of what clearly is such a sheet
};

struct MendedSurface
{
  DataSet surface; ///< with the points of the input, by their ids
  /// A line for each mend, and for what looks like a defect, with the option that mends it.
  std::vector<std::string> notes;
};

/// Throws InputError where a length of the request does not fit the surface.
MendedSurface mendSurface(const DataSet& surface, const MendingRequest& request);
}
