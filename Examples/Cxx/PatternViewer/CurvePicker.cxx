// SPDX-License-Identifier: BSD-3-Clause
#include "CurvePicker.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace viewer
{
namespace
{
constexpr double reach = 8.0; // pixels
/// How far in front of a point the surface hides it, as a fraction of the surface's diagonal.
constexpr double hidden = 0.01;

/// In pixels of the window.
std::array<double, 2> projected(vtkRenderer* renderer, const std::array<double, 3>& point)
{
  renderer->SetWorldPoint(point[0], point[1], point[2], 1.0);
  renderer->WorldToDisplay();
  const double* const display = renderer->GetDisplayPoint();
  return { display[0], display[1] };
}

/// Parameter of the point of a segment that is nearest to a place.
double nearest(
  const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<int, 2>& place)
{
  const double u = b[0] - a[0];
  const double v = b[1] - a[1];
  const double square = u * u + v * v;
  const double along = (place[0] - a[0]) * u + (place[1] - a[1]) * v;
  return square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
}

/// Whether a surface lies between a point and the eye.
class Occlusion
{
public:
  Occlusion(vtkPolyData* surface, vtkCamera* camera)
    : Length(surface->GetLength())
  {
    this->Locator->SetDataSet(surface);
    this->Locator->BuildLocator();
    camera->GetDirectionOfProjection(this->Direction.data()); // the projection is parallel
  }

  bool hides(const std::array<double, 3>& point)
  {
    double start[3];
    double end[3];
    for (int k = 0; k < 3; ++k)
    {
      start[k] = point[k] - 2.0 * this->Length * this->Direction[k];
      end[k] = point[k] - hidden * this->Length * this->Direction[k];
    }
    double t = 0.0;
    double hit[3];
    double coordinates[3];
    int subId = 0;
    vtkIdType cell = -1;
    return this->Locator->IntersectWithLine(start, end, 0.0, t, hit, coordinates, subId, cell) != 0;
  }

private:
  vtkNew<vtkStaticCellLocator> Locator;
  std::array<double, 3> Direction{};
  double Length;
};
}

//------------------------------------------------------------------------------
int pickCurve(
  const PatternModel& model, vtkRenderer* renderer, bool inPlane, const std::array<int, 2>& place)
{
  Occlusion occlusion(model.result().cut, renderer->GetActiveCamera());
  int found = -1;
  double least = reach;
  for (int curve = 0; curve < model.numberOfCurves(); ++curve)
  {
    for (const Segment& segment : model.segments(curve, inPlane))
    {
      const std::array<double, 2> a = projected(renderer, segment.start);
      const std::array<double, 2> b = projected(renderer, segment.end);
      const double t = nearest(a, b, place);
      const double distance =
        std::hypot(a[0] + t * (b[0] - a[0]) - place[0], a[1] + t * (b[1] - a[1]) - place[1]);
      if (distance >= least)
      {
        continue;
      }
      std::array<double, 3> point;
      for (int k = 0; k < 3; ++k)
      {
        point[k] = segment.start[k] + t * (segment.end[k] - segment.start[k]);
      }
      if (inPlane || !occlusion.hides(point))
      {
        least = distance;
        found = curve;
      }
    }
  }
  return found;
}
}
