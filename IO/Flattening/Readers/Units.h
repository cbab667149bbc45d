// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <string>
#include <string_view>

namespace wirewarp
{
/// The unit that a word names in a file, as it is called here: "mm", "cm", "m" or "inch". Empty
/// where it is none of these.
std::string unitNamed(std::string_view word);

/// The unit that a comment states, such as "units: cm" or "File units = millimeters"; empty for
/// none.
std::string unitInComment(std::string_view comment);

/// Of one of the units that are named above.
double millimetresOf(const std::string& unit);

/// A length as users write it, such as 12, 12mm or 0.5in.
struct Length
{
  double value = 0.0;
  std::string unit; ///< empty: none is written
};

/// \return whether the text is a number, with a unit or without
bool parseLength(std::string_view text, Length& length);

/// What the field array `LengthUnit` of a data set states; empty: nothing.
std::string unitOf(const DataSet& data);
/// States the unit; an empty one is taken away.
void setUnit(DataSet& data, const std::string& unit);

/// The unit that is taken where none is stated.
struct LikelyUnit
{
  std::string unit = "cm";
  double size = 0.0; ///< largest side of the triangles' bounding box, in this unit
};

/// The unit in which a surface is nearest to the size of what people wear and sit on: mm, cm or m.
LikelyUnit likelyUnit(const DataSet& surface);

/// "states no unit: cm is taken, in which it is 74.5 cm large", behind the name of a surface.
std::string describe(const LikelyUnit& taken);
}
