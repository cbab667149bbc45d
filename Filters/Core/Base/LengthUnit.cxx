// SPDX-License-Identifier: BSD-3-Clause
#include "Base/LengthUnit.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace flattening
{
namespace
{
struct KnownUnit
{
  Unit unit;
  const char* name;
  double millimetres;
  std::array<const char*, 4> otherNames;
};

constexpr std::array<KnownUnit, 4> knownUnits{ {
  { Unit::Centimetre, "cm", 10.0, { "centimeter", "centimeters", "centimetre", "centimetres" } },
  { Unit::Millimetre, "mm", 1.0, { "millimeter", "millimeters", "millimetre", "millimetres" } },
  { Unit::Metre, "m", 1000.0, { "meter", "meters", "metre", "metres" } },
  { Unit::Inch, "inch", 25.4, { "in", "inches", "in", "inches" } },
} };

const KnownUnit& known(Unit unit)
{
  const auto found = std::find_if(knownUnits.begin(), knownUnits.end(),
    [unit](const KnownUnit& candidate) { return candidate.unit == unit; });
  return found == knownUnits.end() ? knownUnits.front() : *found;
}
}

double millimetresPer(Unit unit)
{
  return known(unit).millimetres;
}

const char* unitName(Unit unit)
{
  return known(unit).name;
}

Unit unitNamed(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found =
    std::find_if(knownUnits.begin(), knownUnits.end(), [&name](const KnownUnit& candidate) {
      const auto& others = candidate.otherNames;
      return name == candidate.name ||
        std::find(others.begin(), others.end(), name) != others.end();
    });
  return found == knownUnits.end() ? Unit::Unspecified : found->unit;
}
}
