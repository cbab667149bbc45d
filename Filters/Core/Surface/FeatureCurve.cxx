// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/FeatureCurve.h"

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

std::string quotedNames(const std::vector<FeatureCurve>& curves, const Indices& ids)
{
  std::string text;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    text += (i == 0 ? "\"" : i + 1 == ids.size() ? " and \"" : ", \"") + curves[ids[i]].name + "\"";
  }
  return text;
}
}
