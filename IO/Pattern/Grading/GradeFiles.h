// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Grading/SizeGrading.h"

namespace flattening::pattern
{
/// An SVG at true scale with the sew lines of all sizes on each other, a layer and a color a size.
std::string makeNest(const Grading& grading, const std::string& name);

/// Comma-separated values, one row for each rule: piece (from 1), point, name, and dx and dy of
/// each size, millimetres across the grain and along it.
std::string makeRuleList(const Grading& grading);

/// The rule table after ASTM D6673, to the texts "# 1", "# 2", ... beside the points of a DXF of
/// the base size: rules with these numbers, along the axes of that drawing.
/// \param unit inches where it is Inch, and millimetres else, as makeDxf() has it
/// \param date year-month-day
std::string makeRuleTable(const Grading& grading, const std::string& name, Unit unit,
  const std::string& date, const std::string& time);
}
