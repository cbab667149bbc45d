// SPDX-License-Identifier: BSD-3-Clause
#include "LocatedSurface.h"

#include "VtkMessages.h"

#include <vtkFlatteningAlgorithm.h>

#include <algorithm>
#include <cmath>

namespace wirewarp
{
//------------------------------------------------------------------------------
std::array<double, 3> pointOf(vtkPolyData* data, vtkIdType p)
{
  std::array<double, 3> point{};
  data->GetPoint(p, point.data());
  return point;
}

//------------------------------------------------------------------------------
bool canBeLocated(const std::array<double, 3>& point)
{
  constexpr double largest = 1e60; // beyond which the filters refuse coordinates
  return std::all_of(point.begin(), point.end(),
    [](double x) { return std::isfinite(x) && std::abs(x) <= largest; });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> locatedTriangles(vtkPolyData* surface)
{
  const VtkMessages messages; // of what the flattening refuses
  auto triangles = vtkSmartPointer<vtkPolyData>::New();
  vtkFlatteningAlgorithm::Triangulate(surface, triangles);
  return triangles->GetNumberOfCells() > 0 ? triangles : nullptr;
}
}
