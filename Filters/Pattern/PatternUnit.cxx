// SPDX-License-Identifier: BSD-3-Clause
#include "PatternUnit.h"

namespace flattening
{
namespace pattern
{
double millimetresPer(Unit unit)
{
  switch (unit)
  {
    case Unit::Millimetre:
      return 1.0;
    case Unit::Metre:
      return 1000.0;
    case Unit::Inch:
      return 25.4;
    default:
      return 10.0;
  }
}

const char* unitName(Unit unit)
{
  switch (unit)
  {
    case Unit::Millimetre:
      return "mm";
    case Unit::Metre:
      return "m";
    case Unit::Inch:
      return "inch";
    default:
      return "cm";
  }
}
}
}
