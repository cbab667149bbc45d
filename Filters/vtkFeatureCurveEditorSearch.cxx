// SPDX-License-Identifier: BSD-3-Clause
// What vtkFeatureCurveEditor finds near a point, and the segment that would come next.
#include "vtkFeatureCurveEditor.h"

#include "CurveEditorData.h"
#include "CurveEditorModel.h"
#include "Editing/CurveDrawing.h"
#include "Editing/CurveSnapping.h"
#include "Paths/PathDistance.h"

#include "vtkMath.h"
#include "vtkPolyData.h"

#include <limits>

using namespace flattening;
using bridge::idOf;
using bridge::isFinite;
using bridge::kindOf;
using bridge::pointOf;

namespace
{
double distanceTo(const SurfacePath& path, const SightMetric& sight, const Point3& point)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < path.points.size(); ++k)
  {
    const Point3& a = path.points[k - 1].position;
    const Point3& b = path.points[k].position;
    const Point3 nearest = a + sight.nearestFraction(a, b, point) * (b - a);
    least = std::min(least, sight.distance(nearest, point));
  }
  return least;
}
}

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::SetViewDirection(const double direction[3])
{
  if (isFinite(direction))
  {
    std::copy_n(direction, 3, this->ViewDirection);
  }
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::SnapPoint(
  const double point[3], double reach, int exceptCurve, double snapped[3]) const
{
  std::copy_n(point, 3, snapped);
  if (!this->Drawn || !isFinite(point))
  {
    return NOTHING;
  }
  SnapOptions options;
  options.reach = reach;
  options.boundary = this->SnapToBoundary;
  options.corner = this->SnapToCorners;
  options.vertex = this->SnapToVertices;
  options.curve = this->SnapToCurves;
  options.dartTip = this->SnapToDartTips;
  options.mirrorPlane = this->SnapToMirrorPlane;
  options.exceptCurve = exceptCurve;
  options.sight = SightMetric(pointOf(this->ViewDirection));
  const DrawingSurface& surface = this->Drawn->editor.surface();
  const SnappedPoint result =
    snapPoint(surface, this->Drawn->editor.state(), surface.pointNear(pointOf(point)), options);
  std::copy_n(result.point.position.data(), 3, snapped);
  return static_cast<int>(result.target);
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::PreviewSegment(
  const double from[3], const double to[3], int kind, vtkPolyData* line) const
{
  line->Initialize();
  if (!this->Drawn || !isFinite(from) || !isFinite(to))
  {
    return -1.0;
  }
  const DrawingSurface& surface = this->Drawn->editor.surface();
  const DrawnSegment drawn = this->Drawn->preview.draw(
    kindOf(kind), surface.pointNear(pointOf(from)), surface.pointNear(pointOf(to)));
  if (drawn.status.refused())
  {
    return -1.0;
  }
  bridge::writePath(drawn.path, line);
  return lengthOf(drawn.path);
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::GetDistance(int curve, const double point[3]) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  if (!found || found->segments.empty() || !isFinite(point))
  {
    return vtkMath::Nan();
  }
  const DrawingSurface& surface = this->Drawn->editor.surface();
  const PathDistance distance =
    distanceFrom(surface.graph(), wholePath(*found), surface.pointNear(pointOf(point)));
  return distance.way.status.refused() ? vtkMath::Nan()
    : distance.left                    ? distance.way.length
                                       : -distance.way.length;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::FindNode(const double point[3], double reach, int found[2]) const
{
  const SightMetric sight(pointOf(this->ViewDirection));
  double least = reach;
  for (int curve = 0; curve < this->GetNumberOfCurves(); ++curve)
  {
    for (int node = 0; node < this->GetNumberOfNodes(curve); ++node)
    {
      const double distance =
        sight.distance(this->Drawn->curve(curve)->nodes[idOf(node)].position, pointOf(point));
      if (distance < least)
      {
        least = distance;
        found[0] = curve;
        found[1] = node;
      }
    }
  }
  return least < reach;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::FindSegment(const double point[3], double reach, int found[2]) const
{
  const SightMetric sight(pointOf(this->ViewDirection));
  double least = reach;
  for (int curve = 0; curve < this->GetNumberOfCurves(); ++curve)
  {
    for (int segment = 0; segment < this->GetNumberOfSegments(curve); ++segment)
    {
      const double distance =
        distanceTo(this->Drawn->curve(curve)->segments[idOf(segment)], sight, pointOf(point));
      if (distance < least)
      {
        least = distance;
        found[0] = curve;
        found[1] = segment;
      }
    }
  }
  return least < reach;
}
