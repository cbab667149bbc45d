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

/// The unit of a name, in capital letters or not; Unspecified where it is none of these.
Unit unitNamed(std::string name);
}
