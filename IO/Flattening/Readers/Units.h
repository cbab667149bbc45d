// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
}
