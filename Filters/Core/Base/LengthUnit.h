// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace flattening
{
/// Unit of length of a surface.
enum class Unit
{
  Unspecified, ///< taken as centimetres, with a warning
  Millimetre,
  Centimetre,
  Metre,
  Inch,
};

/// How many millimetres one unit is, exactly.
double millimetresPer(Unit unit);

/// "mm", "cm", "m", "inch"; "cm" where unspecified.
const char* unitName(Unit unit);

/// The unit of a name, also a long one as "Inches" or "millimetre", in letters of any case;
/// Unspecified where it is another one.
Unit unitNamed(std::string name);
}
