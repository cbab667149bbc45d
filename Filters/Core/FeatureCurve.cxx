// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureCurve.h"

namespace flattening
{
const char* curveTypeName(CurveType type)
{
  switch (type)
  {
    case CurveType::Accessory:
      return "accessory";
    case CurveType::Key:
      return "key";
    case CurveType::Dart:
      return "dart";
    case CurveType::Seam:
      return "seam";
  }
  return "unknown";
}
}
