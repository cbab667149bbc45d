// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkSurfaceDevelopability.h"

#include <cstdlib>

int TestSurfaceDevelopability(int, char*[])
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkSurfaceDevelopability> developability;
  developability->SetInputConnection(plane->GetOutputPort());
  developability->Update();
  return developability->GetOutput()->GetNumberOfPoints() == 4 ? EXIT_SUCCESS : EXIT_FAILURE;
}
