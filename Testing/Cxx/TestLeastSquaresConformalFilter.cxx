// SPDX-License-Identifier: BSD-3-Clause
// The comparison method: Table 1's row of the quarter-sphere.
#include "FlatteningTesting.h"

#include "vtkLeastSquaresConformalFilter.h"

using namespace flatteningTesting;

namespace
{
// Table 1 prints E_len 64.3, E_ang 42.1 (in thousandths), E_h 0.582, E_r 0.672; more digits are
// from a separate implementation.
void tableOneOfTheConformalMapIsReproduced(Checks& check)
{
  const auto surface = makeQuarterSphere();
  vtkNew<vtkLeastSquaresConformalFilter> filter;
  filter->SetInputData(surface);
  filter->SetCurvesData(makeQuarterSphereArc(surface));
  filter->AreaNormalizedOff();
  filter->SetPins(lunePoint(0, 4), lunePoint(0, 5));
  filter->Update();
  check.equal(std::string(filter->GetStatusName()), "Ok", "status");
  check.near(number(filter, "EdgeLengthError"), 0.06433, 5e-6, "E_len");
  check.near(number(filter, "AngleErrorMean"), 0.04216, 5e-6, "E_ang");
  check.near(number(filter, "GlobalHomogeneity"), 0.58187, 5e-6, "E_h");
  check.near(number(filter, "GlobalAspectRatio"), 0.672, 5e-4, "E_r");
}
}

int TestLeastSquaresConformalFilter(int, char*[])
{
  Checks check;
  tableOneOfTheConformalMapIsReproduced(check);
  return check.result();
}
