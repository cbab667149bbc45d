// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePicker.h"

#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening::interaction
{
namespace
{
constexpr int directions = 16;
constexpr double leastFacing = 0.1;      // cosine; a surface seen from the very side has no end
constexpr vtkIdType mirrorSamples = 500; // points, which tell a symmetry

/// The point of the scene at a place in the window, at a depth from 0, near, to 1.
std::array<double, 3> worldAt(vtkRenderer* renderer, double x, double y, double depth)
{
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  const double* const world = renderer->GetWorldPoint();
  return { world[0] / world[3], world[1] / world[3], world[2] / world[3] };
}

/// Twice the area of a polygon along its normal. \return whether it has one
bool areaNormal(vtkPolyData* surface, vtkIdType cell, double normal[3])
{
  vtkNew<vtkIdList> points;
  surface->GetCellPoints(cell, points);
  std::fill(normal, normal + 3, 0.0);
  double first[3];
  for (vtkIdType k = 1; k + 1 < points->GetNumberOfIds(); ++k)
  {
    double one[3];
    double other[3];
    double twice[3];
    surface->GetPoint(points->GetId(0), first);
    surface->GetPoint(points->GetId(k), one);
    surface->GetPoint(points->GetId(k + 1), other);
    vtkMath::Subtract(one, first, one);
    vtkMath::Subtract(other, first, other);
    vtkMath::Cross(one, other, twice);
    vtkMath::Add(normal, twice, normal);
  }
  return vtkMath::Norm(normal) > 0.0;
}

/// 1 or -1 where the normals of a surface go all ways, as those of a body do, and point away from
/// its middle or to it; 0 for a sheet, of which either side may be drawn on.
double outwardsOf(vtkPolyData* surface)
{
  constexpr double sheet = 0.4; // of the area, that is seen from one side
  double center[3];
  surface->GetCenter(center);
  double whole[3] = { 0.0, 0.0, 0.0 };
  double area = 0.0;
  double away = 0.0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    double normal[3];
    if (areaNormal(surface, cell, normal))
    {
      double way[3];
      surface->GetPoint(surface->GetCell(cell)->GetPointId(0), way);
      vtkMath::Subtract(way, center, way);
      vtkMath::Add(whole, normal, whole);
      area += vtkMath::Norm(normal);
      away += vtkMath::Dot(normal, way);
    }
  }
  return vtkMath::Norm(whole) > sheet * area ? 0.0 : away > 0.0 ? 1.0 : -1.0;
}

/// Length of a pixel at a point, in the unit of the scene.
double pixelSize(vtkRenderer* renderer, const std::array<double, 3>& point)
{
  renderer->SetWorldPoint(point[0], point[1], point[2], 1.0);
  renderer->WorldToDisplay();
  const double* const display = renderer->GetDisplayPoint();
  const double x = display[0];
  const double y = display[1];
  const double depth = display[2];
  const std::array<double, 3> beside = worldAt(renderer, x + 1.0, y, depth);
  return std::sqrt(vtkMath::Distance2BetweenPoints(point.data(), beside.data()));
}
}

void SurfacePicker::setSurface(vtkPolyData* surface)
{
  const bool any = surface && surface->GetNumberOfCells() > 0;
  this->Surface = any ? surface : nullptr;
  this->Outwards = 0.0;
  if (any)
  {
    this->Locator->SetDataSet(surface);
    this->Locator->BuildLocator();
    this->Outwards = outwardsOf(surface);
  }
}

bool SurfacePicker::isInside(vtkIdType triangle, const std::array<double, 3>& way) const
{
  double normal[3];
  return this->Outwards != 0.0 && areaNormal(this->Surface, triangle, normal) &&
    this->Outwards * vtkMath::Dot(normal, way.data()) > 0.0;
}

bool SurfacePicker::pickPixel(vtkRenderer* renderer, double x, double y, SurfacePick& picked) const
{
  const std::array<double, 3> start = worldAt(renderer, x, y, 0.0);
  const std::array<double, 3> end = worldAt(renderer, x, y, 1.0);
  double t = 0.0;
  double coordinates[3];
  int subId = 0;
  vtkIdType id = -1;
  if (this->Locator->IntersectWithLine(
        start.data(), end.data(), 0.0, t, picked.point.data(), coordinates, subId, id) == 0)
  {
    return false;
  }
  // Through an opening, where who aims at the border has missed it.
  if (this->isInside(id, { end[0] - start[0], end[1] - start[1], end[2] - start[2] }))
  {
    return false;
  }
  picked.pixel = pixelSize(renderer, picked.point);
  return true;
}

bool SurfacePicker::pick(
  vtkRenderer* renderer, const std::array<int, 2>& pixel, int around, SurfacePick& picked) const
{
  if (!this->Surface)
  {
    return false;
  }
  if (this->pickPixel(renderer, pixel[0], pixel[1], picked))
  {
    return true;
  }
  for (int radius = 2; radius <= around; radius += 2)
  {
    for (int k = 0; k < directions; ++k)
    {
      const double angle = 2.0 * vtkMath::Pi() * k / directions;
      if (this->pickPixel(renderer, pixel[0] + radius * std::cos(angle),
            pixel[1] + radius * std::sin(angle), picked))
      {
        return true;
      }
    }
  }
  return false;
}

Symmetry SurfacePicker::symmetry() const
{
  Symmetry best;
  if (!this->Surface)
  {
    return best;
  }
  std::array<double, 3> center;
  this->Surface->GetCenter(center.data());
  best.origin = center;
  double least = std::numeric_limits<double>::infinity();
  vtkNew<vtkGenericCell> cell;
  const vtkIdType step = std::max<vtkIdType>(1, this->Surface->GetNumberOfPoints() / mirrorSamples);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double sum = 0.0;
    double moved = 0.0;
    for (vtkIdType k = 0; k < this->Surface->GetNumberOfPoints(); k += step)
    {
      std::array<double, 3> image;
      this->Surface->GetPoint(k, image.data());
      moved += 4.0 * (center[axis] - image[axis]) * (center[axis] - image[axis]);
      image[axis] = 2.0 * center[axis] - image[axis];
      double closest[3];
      vtkIdType id = -1;
      int subId = 0;
      double square = 0.0;
      this->Locator->FindClosestPoint(image.data(), closest, cell, id, subId, square);
      sum += square;
    }
    // Against how far the image is, or a sheet would be its own across.
    if (sum < least * moved)
    {
      least = sum / moved;
      best.error = std::sqrt(least);
      best.normal = { 0.0, 0.0, 0.0 };
      best.normal[axis] = 1.0;
    }
  }
  return best;
}
}
