// SPDX-License-Identifier: BSD-3-Clause
#include "StraightCorners.h"

#include <vtkFeatureCurveAlgorithm.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <array>
#include <cmath>

namespace editor
{
namespace
{
constexpr double cornerDegrees = 30.0;
/// The direction of a segment at its end is that of so much of it: edges zigzag.
constexpr double partOfSegment = 0.25;

using CurvePoint = std::array<double, 3>;

/// The point of a line at a length from its first point, or from its last one.
CurvePoint placeOn(vtkPolyData* lines, vtkIdType cell, double length, bool fromEnd)
{
  vtkNew<vtkIdList> ids;
  lines->GetCellPoints(cell, ids);
  const vtkIdType count = ids->GetNumberOfIds();
  CurvePoint last{};
  for (vtkIdType k = 0; k < count; ++k)
  {
    CurvePoint place{};
    lines->GetPoint(ids->GetId(fromEnd ? count - 1 - k : k), place.data());
    const double step =
      k > 0 ? std::sqrt(vtkMath::Distance2BetweenPoints(last.data(), place.data())) : 0.0;
    if (k > 0 && step >= length)
    {
      const double share = step > 0.0 ? length / step : 0.0;
      for (std::size_t i = 0; i < place.size(); ++i)
      {
        last[i] += share * (place[i] - last[i]);
      }
      return last;
    }
    length -= step;
    last = place;
  }
  return last;
}

/// By how many degrees a curve turns from a segment to the next.
double turnAfter(const vtkFeatureCurveEditor* curves, int curve, int segment, vtkPolyData* lines)
{
  const double before = partOfSegment * curves->GetSegmentLength(curve, segment);
  const double after = partOfSegment * curves->GetSegmentLength(curve, segment + 1);
  const CurvePoint from = placeOn(lines, segment, before, true);
  const CurvePoint node = placeOn(lines, segment + 1, 0.0, false);
  const CurvePoint to = placeOn(lines, segment + 1, after, false);
  CurvePoint in{};
  CurvePoint out{};
  vtkMath::Subtract(node.data(), from.data(), in.data());
  vtkMath::Subtract(to.data(), node.data(), out.data());
  return vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(in.data(), out.data()));
}
}

std::string cornersOfStraightKeys(const vtkFeatureCurveEditor* curves)
{
  for (int curve = 0; curve < curves->GetNumberOfCurves(); ++curve)
  {
    if (curves->GetCurveType(curve) != vtkFeatureCurveAlgorithm::KEY ||
      curves->GetCurveKeyShape(curve) == 0)
    {
      continue;
    }
    const std::string name = "\"" + curves->GetCurveName(curve) + "\"";
    if (curves->GetCurveClosed(curve))
    {
      return name + " is closed and cannot be straight in the plane; let it keep its shape [T]";
    }
    vtkNew<vtkPolyData> lines; // one a segment
    curves->GetCurve(curve, lines);
    for (int segment = 0; segment + 1 < curves->GetNumberOfSegments(curve); ++segment)
    {
      const double turn = turnAfter(curves, curve, segment, lines);
      if (turn > cornerDegrees)
      {
        return name + " cannot be straight in the plane, since it turns by " +
          std::to_string(std::lround(turn)) + " degrees at its node " +
          std::to_string(segment + 2) +
          "; split it there [X], so that both parts are straight, or let it keep its shape [T]";
      }
    }
  }
  return {};
}
}
