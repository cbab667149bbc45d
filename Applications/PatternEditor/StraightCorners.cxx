// SPDX-License-Identifier: BSD-3-Clause
#include "StraightCorners.h"

#include <vtkFeatureCurveAlgorithm.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <Eigen/Core>

#include <cmath>

namespace editor
{
namespace
{
constexpr double cornerDegrees = 30.0;
/// The direction of a segment at its end is that of so much of it: edges zigzag.
constexpr double partOfSegment = 0.25;

/// The point of a line at a length from its first point, or from its last one.
Eigen::Vector3d placeOn(vtkPolyData* lines, vtkIdType cell, double length, bool fromEnd)
{
  vtkNew<vtkIdList> ids;
  lines->GetCellPoints(cell, ids);
  const vtkIdType count = ids->GetNumberOfIds();
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (vtkIdType k = 0; k < count; ++k)
  {
    Eigen::Vector3d place;
    lines->GetPoint(ids->GetId(fromEnd ? count - 1 - k : k), place.data());
    const double step = k > 0 ? (place - last).norm() : 0.0;
    if (k > 0 && step >= length)
    {
      return step > 0.0 ? Eigen::Vector3d(last + length / step * (place - last)) : last;
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
  const Eigen::Vector3d node = placeOn(lines, segment + 1, 0.0, false);
  const Eigen::Vector3d in = node - placeOn(lines, segment, before, true);
  const Eigen::Vector3d out = placeOn(lines, segment + 1, after, false) - node;
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
