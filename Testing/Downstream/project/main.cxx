// SPDX-License-Identifier: BSD-3-Clause
// The apex of a pyramid with base corners (+-1, +-1, 0) and height 1: its four angles are
// acos(1/3).
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSurfaceDevelopability.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

int main()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 1.0);
  points->InsertNextPoint(1.0, 1.0, 0.0);
  points->InsertNextPoint(-1.0, 1.0, 0.0);
  points->InsertNextPoint(-1.0, -1.0, 0.0);
  points->InsertNextPoint(1.0, -1.0, 0.0);
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const vtkIdType triangle[3] = { 0, 1 + i, 1 + (i + 1) % 4 };
    triangles->InsertNextCell(3, triangle);
  }
  vtkNew<vtkPolyData> pyramid;
  pyramid->SetPoints(points);
  pyramid->SetPolys(triangles);

  vtkNew<vtkSurfaceDevelopability> filter;
  filter->SetInputData(pyramid);
  filter->Update();
  vtkDataArray* values = filter->GetOutput()->GetPointData()->GetArray("Developability");
  if (!values)
  {
    std::puts("no array Developability");
    return EXIT_FAILURE;
  }
  const double expected = 2.0 * std::acos(-1.0) - 4.0 * std::acos(1.0 / 3.0);
  const double apex = values->GetComponent(0, 0);
  std::printf("Developability of the apex %.15g, expected %.15g\n", apex, expected);
  return std::abs(apex - expected) < 1e-14 ? EXIT_SUCCESS : EXIT_FAILURE;
}
