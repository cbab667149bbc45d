// SPDX-License-Identifier: BSD-3-Clause
// vtkSewnShape: distances are those that VTK's locator finds, and what cannot be sewn is refused.
#include "FlatteningTesting.h"

#include "vtkSewnShape.h"
#include "vtkStaticCellLocator.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
vtkSmartPointer<vtkPolyData> makeDome()
{
  return makeGrid(10, 10, [](double x, double y) {
    return 0.2 * std::sin(vtkMath::Pi() * x) * std::sin(vtkMath::Pi() * y);
  });
}

void distancesAreThoseThatALocatorFinds(Checks& check)
{
  const auto dome = makeDome();
  vtkNew<vtkWireWarpingFilter> flattening;
  flattening->SetInputData(dome);
  vtkNew<vtkSewnShape> sewn;
  sewn->SetInputConnection(flattening->GetOutputPort(0));
  sewn->SetDesignConnection(flattening->GetOutputPort(2));
  sewn->Update();
  double largest = 0.0;
  for (int side = 0; side < 2; ++side)
  {
    vtkPolyData* from = side == 0 ? sewn->GetOutput() : sewn->GetDesignOutput();
    vtkPolyData* to = side == 0 ? sewn->GetDesignOutput() : sewn->GetOutput();
    vtkNew<vtkStaticCellLocator> locator;
    locator->SetDataSet(to);
    locator->BuildLocator();
    vtkDataArray* distances = from->GetPointData()->GetArray("Distance");
    check.that(distances != nullptr, "Distance is there");
    for (vtkIdType p = 0; distances && p < from->GetNumberOfPoints(); ++p)
    {
      double closest[3];
      vtkIdType cell = 0;
      int part = 0;
      double distance2 = 0.0;
      locator->FindClosestPoint(from->GetPoint(p), closest, cell, part, distance2);
      check.near(distances->GetComponent(p, 0), std::sqrt(distance2), 1e-7, "Distance");
      largest = std::max(largest, std::sqrt(distance2));
    }
  }
  vtkPolyData* output = sewn->GetOutput();
  check.near(number(sewn->GetShapes(), "DistanceMax"), largest, 1e-7, "Hausdorff distance");
  check.that(largest > 1e-3, "the cloth moves");
  check.equal(number(sewn->GetShapes(), "Converged"), 1.0, "Converged");
  check.equal(output->GetNumberOfPoints(), dome->GetNumberOfPoints(), "points");
  check.equal(
    output->GetCellData()->GetArray("PrincipalStrains")->GetNumberOfComponents(), 2, "strains");
  check.that(output->GetCellData()->GetArray("NormalDeviation") != nullptr, "NormalDeviation");
  check.that(output->GetCellData()->GetArray("vtkOriginalCellIds") != nullptr, "data of the input");
  check.equal(static_cast<double>(sewn->GetIterations()->GetNumberOfRows()),
    number(sewn->GetShapes(), "Iterations") + 1, "iterations");
}

void whatCannotBeSewnIsRefused(Checks& check)
{
  const auto flattening = updated<vtkWireWarpingFilter>(makeDome());
  vtkNew<vtkSewnShape> sewn;
  const Messages messages(sewn);
  sewn->SetInputData(flattening->GetOutput(0));
  sewn->SetDesignData(flattening->GetOutput(2));
  sewn->SetTestToProduct();
  sewn->Update();
  check.equal(sewn->GetStatusCode(), static_cast<int>(vtkSewnShape::INVALID_OPTION), "lone panel");
  check.contains(sewn->GetStatusMessage(), "sewn to nothing", "its reason");
  check.contains(sewn->GetStatusMessage(), "use Test = PANEL", "its remedy");
  check.that(isEmpty(sewn->GetOutput()) && isEmpty(sewn->GetDesignOutput()), "no output");
  check.equal(text(sewn->GetOutput(), "RunStatus"), std::string("InvalidOption"), "RunStatus");

  sewn->SetTestToPanel();
  sewn->SetDesignData(makeGrid(3, 3));
  sewn->Update();
  check.equal(sewn->GetStatusCode(), static_cast<int>(vtkSewnShape::INVALID_OPTION), "other mesh");

  // Rows of SeamPairs that name no boundary edges, or points that are not there.
  for (const std::array<vtkIdType, 5>& row :
    { std::array<vtkIdType, 5>{ 0, 60, 1, 61, 0 }, { 0, 1, 5000, 2, 0 }, { 0, 1, -1, 2, 0 } })
  {
    vtkNew<vtkPolyData> flat;
    flat->DeepCopy(flattening->GetOutput(0));
    vtkNew<vtkIdTypeArray> pairs;
    pairs->SetName("SeamPairs");
    pairs->SetNumberOfComponents(5);
    pairs->InsertNextTypedTuple(row.data());
    flat->GetFieldData()->AddArray(pairs);
    sewn->SetInputData(flat);
    sewn->SetDesignData(flattening->GetOutput(2));
    sewn->Update();
    check.equal(sewn->GetStatusCode(), static_cast<int>(vtkSewnShape::INVALID_OPTION), "SeamPairs");
    check.contains(sewn->GetStatusMessage(), "row 0 of SeamPairs", "which row");
  }
  check.equal(messages.errors.size(), 5U, "an error each");
}
}

int TestSewnShape(int, char*[])
{
  Checks check;
  distancesAreThoseThatALocatorFinds(check);
  whatCannotBeSewnIsRefused(check);
  return check.result();
}
