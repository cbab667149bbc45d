// SPDX-License-Identifier: BSD-3-Clause
// The developability of Eq. 25 against angles known in closed form and the theorem of Gauss-Bonnet.
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceDevelopability.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>

namespace
{
constexpr int side = 12;

// A grid over (u, v) in [0, 1] x [0, 1], each square cut into two triangles.
vtkSmartPointer<vtkPolyData> makeSheet(
  const std::function<void(double u, double v, double point[3])>& shape)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j <= side; ++j)
  {
    for (int i = 0; i <= side; ++i)
    {
      double point[3];
      shape(static_cast<double>(i) / side, static_cast<double>(j) / side, point);
      points->InsertNextPoint(point);
    }
  }
  for (vtkIdType j = 0; j < side; ++j)
  {
    for (vtkIdType i = 0; i < side; ++i)
    {
      const vtkIdType a = j * (side + 1) + i;
      const vtkIdType c = a + side + 2;
      const vtkIdType lower[3] = { a, a + 1, c };
      const vtkIdType upper[3] = { a, c, a + side + 1 };
      triangles->InsertNextCell(3, lower);
      triangles->InsertNextCell(3, upper);
    }
  }
  auto sheet = vtkSmartPointer<vtkPolyData>::New();
  sheet->SetPoints(points);
  sheet->SetPolys(triangles);
  return sheet;
}

bool onBoundary(vtkIdType id)
{
  const vtkIdType i = id % (side + 1);
  const vtkIdType j = id / (side + 1);
  return i == 0 || j == 0 || i == side || j == side;
}

vtkSmartPointer<vtkPolyData> measure(vtkPolyData* surface)
{
  vtkNew<vtkSurfaceDevelopability> filter;
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

double angleSum(vtkPolyData* surface, vtkIdType id)
{
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    const vtkIdType* corner;
    vtkIdType count;
    surface->GetCellPoints(cell, count, corner);
    for (vtkIdType k = 0; k < count; ++k)
    {
      if (corner[k] == id)
      {
        double here[3], next[3], previous[3];
        surface->GetPoint(id, here);
        surface->GetPoint(corner[(k + 1) % 3], next);
        surface->GetPoint(corner[(k + 2) % 3], previous);
        vtkMath::Subtract(next, here, next);
        vtkMath::Subtract(previous, here, previous);
        sum += vtkMath::AngleBetweenVectors(next, previous);
      }
    }
  }
  return sum;
}

bool check(bool holds, const char* fact)
{
  if (!holds)
  {
    std::cerr << "Does not hold: " << fact << "\n";
  }
  return holds;
}
}

int TestSurfaceDevelopability(int, char*[])
{
  bool passed = true;

  // A grid of rulings: the triangles at every interior point unroll into the plane.
  auto cylinder = makeSheet([](double u, double v, double point[3]) {
    point[0] = std::cos(2.0 * u);
    point[1] = std::sin(2.0 * u);
    point[2] = v;
  });
  vtkNew<vtkDoubleArray> carried;
  carried->SetName("Carried");
  carried->SetNumberOfTuples(cylinder->GetNumberOfPoints());
  carried->FillValue(7.0);
  cylinder->GetPointData()->AddArray(carried);
  auto flat = measure(cylinder);
  vtkDataArray* values = flat->GetPointData()->GetArray("Developability");
  if (!check(values && values->GetNumberOfTuples() == cylinder->GetNumberOfPoints(),
        "there is one value a point"))
  {
    return EXIT_FAILURE;
  }
  double range[2];
  values->GetRange(range);
  passed &= check(range[0] >= 0.0 && range[1] < 1e-13, "a cylinder is developable");
  passed &= check(flat->GetPointData()->GetArray("Carried") == carried,
    "point data of the input is carried along");
  passed &=
    check(!cylinder->GetPointData()->HasArray("Developability"), "the input stays as it is");

  // A cap of the unit sphere: every interior point is an elliptic one, so that the values add up to
  // the total curvature, 2 pi less the turning of the boundary (Gauss-Bonnet).
  const auto cap = [](double scale) {
    return makeSheet([scale](double u, double v, double point[3]) {
      const double longitude = 1.2 * u;
      const double latitude = 0.9 * v - 0.2;
      point[0] = scale * std::cos(latitude) * std::cos(longitude);
      point[1] = scale * std::cos(latitude) * std::sin(longitude);
      point[2] = scale * std::sin(latitude);
    });
  };
  auto unit = cap(1.0);
  auto measured = measure(unit);
  values = measured->GetPointData()->GetArray("Developability");
  double total = 0.0;
  double turning = 0.0;
  bool boundaryIsZero = true;
  unit->BuildCells();
  for (vtkIdType id = 0; id < unit->GetNumberOfPoints(); ++id)
  {
    total += values->GetComponent(id, 0);
    if (onBoundary(id))
    {
      turning += vtkMath::Pi() - angleSum(unit, id);
      boundaryIsZero &= values->GetComponent(id, 0) == 0.0;
    }
  }
  passed &= check(boundaryIsZero, "boundary points have the value 0");
  passed &= check(total > 0.5 && std::abs(total + turning - 2.0 * vtkMath::Pi()) < 1e-12,
    "the values of a spherical cap and the turning of its boundary add up to 2 pi");

  auto large = cap(1e6);
  auto measuredLarge = measure(large);
  vtkDataArray* others = measuredLarge->GetPointData()->GetArray("Developability");
  double difference = 0.0;
  for (vtkIdType id = 0; id < unit->GetNumberOfPoints(); ++id)
  {
    difference =
      std::max(difference, std::abs(values->GetComponent(id, 0) - others->GetComponent(id, 0)));
  }
  passed &= check(difference < 1e-12, "the values do not depend on the unit of length");
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
