// SPDX-License-Identifier: BSD-3-Clause
// The comparison method: Table 1's row of the quarter-sphere, darts, pins.
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

void dartsAreOpenedFirst(Checks& check)
{
  const auto surface = makeQuarterSphere();
  const auto filter = updated<vtkLeastSquaresConformalFilter>(
    surface, makeCurves(surface, { { lunePoint(0, 4), lunePoint(1, 4), lunePoint(2, 4) } }, { 2 }));
  check.equal(filter->GetOutput()->GetNumberOfPoints(), 39, "points with an open dart");
  const double closedError = [&surface] {
    const auto closed = updated<vtkLeastSquaresConformalFilter>(surface);
    return number(closed, "AreaError");
  }();
  check.that(number(filter, "AreaError") < closedError, "a dart lowers E_area");
}

void pinsAreChecked(Checks& check)
{
  vtkNew<vtkLeastSquaresConformalFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(makeGrid(2, 2));
  filter->SetPins(3, -1);
  filter->Update();
  check.contains(filter->GetStatusMessage(), "pins 3", "one pin alone");
  check.equal(filter->GetStatusIds()->GetNumberOfValues(), vtkIdType{ 2 }, "the ids of both");
  filter->SetPins(4, 4);
  filter->Update();
  check.equal(filter->GetStatusCode(),
    static_cast<int>(vtkLeastSquaresConformalFilter::INVALID_OPTION), "status of one pin twice");
  check.equal(messages.errors.size(), std::size_t{ 2 }, "errors");
}
}

int TestLeastSquaresConformalFilter(int, char*[])
{
  Checks check;
  tableOneOfTheConformalMapIsReproduced(check);
  dartsAreOpenedFirst(check);
  pinsAreChecked(check);
  return check.result();
}
