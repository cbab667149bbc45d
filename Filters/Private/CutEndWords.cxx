// SPDX-License-Identifier: BSD-3-Clause
#include "CutEndWords.h"

#include "Cut/CutEnds.h"

#include <cstdio>

namespace flattening
{
namespace bridge
{
namespace
{
/// The point's id in the input, or where it is if the imprint made it.
std::string pointWords(const CurvedSurface& source, Index vertex)
{
  const vtkIdType point = source.pointOf(vertex);
  if (point >= 0)
  {
    return "point " + std::to_string(point);
  }
  const Point3& x = source.imprinted.mesh.point(vertex);
  char place[120];
  std::snprintf(place, sizeof(place), "(%.6g, %.6g, %.6g)", x.x(), x.y(), x.z());
  return place;
}
}

std::vector<std::string> describeShortEnds(const CurvedSurface& source)
{
  std::vector<std::string> sentences;
  const std::vector<FeatureCurve>& curves = source.imprinted.curves;
  for (const ShortEnd& end : endsShortOfBoundary(source.imprinted.mesh, curves))
  {
    const FeatureCurve& curve = curves[end.curve];
    const bool dart = curve.type == CurveType::Dart;
    sentences.push_back(curveTypeName(curve.type) + (" \"" + curve.name) + "\" ends at " +
      pointWords(source, end.vertex) + ", one edge inside the boundary, and " +
      (dart ? "does not open there" : "divides nothing there") + "; begin it at " +
      pointWords(source, end.boundary));
  }
  return sentences;
}
}
}
