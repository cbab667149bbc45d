// SPDX-License-Identifier: BSD-3-Clause
// vtkSewnShape against facts: developables come back, distances are those that VTK's locator finds,
// and what cannot be sewn is refused.
#include "FlatteningTesting.h"

#include "Sewing/PieceSewing.h"

#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkSewnShape.h"
#include "vtkStaticCellLocator.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
/// A closed cylinder of radius 1 about the z axis with two seams.
vtkSmartPointer<vtkPolyData> makeTube(int columns, int rows)
{
  std::vector<std::array<double, 3>> points;
  std::vector<Cell> triangles;
  const auto at = [columns](int i, int j) -> vtkIdType { return j * columns + i % columns; };
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / columns;
      points.push_back({ std::cos(angle), std::sin(angle), 2.0 * j / rows });
      if (j < rows)
      {
        triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
        triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
      }
    }
  }
  return makePolyData(points, triangles);
}

vtkSmartPointer<vtkPolyData> makeTubeSeams(vtkPolyData* tube, int columns, int rows)
{
  Cell first;
  Cell second;
  for (int j = 0; j <= rows; ++j)
  {
    first.push_back(static_cast<vtkIdType>(j) * columns);
    second.push_back(static_cast<vtkIdType>(j) * columns + columns / 2);
  }
  return makeCurves(tube, { first, second }, { 3, 3 });
}

vtkSmartPointer<vtkPolyData> makeDome(double scale)
{
  auto dome = makeGrid(10, 10, [](double x, double y) {
    return 0.2 * std::sin(vtkMath::Pi() * x) * std::sin(vtkMath::Pi() * y);
  });
  for (vtkIdType p = 0; p < dome->GetNumberOfPoints(); ++p)
  {
    double x[3];
    dome->GetPoint(p, x);
    dome->GetPoints()->SetPoint(p, scale * x[0], scale * x[1], scale * x[2]);
  }
  return dome;
}

void theDefaultsAreThoseOfCore(Checks& check)
{
  const flattening::SewingOptions options;
  vtkNew<vtkSewnShape> sewn;
  check.equal(sewn->GetTest(), static_cast<int>(options.test), "Test");
  check.equal(sewn->GetThickness(), options.thickness, "Thickness");
  check.equal(sewn->GetAreaBias(), options.areaBias, "AreaBias");
  check.equal(sewn->GetMaximumIterations(), options.maximumIterations, "MaximumIterations");
}

void aTubeOfTwoPiecesComesBack(Checks& check)
{
  const auto tube = makeTube(24, 6);
  vtkNew<vtkWireWarpingFilter> flattening;
  flattening->SetInputData(tube);
  flattening->SetCurvesData(makeTubeSeams(tube, 24, 6));
  vtkNew<vtkSewnShape> sewn;
  sewn->SetInputConnection(flattening->GetOutputPort(0));
  sewn->SetDesignConnection(flattening->GetOutputPort(2));
  sewn->SetTestToProduct();
  sewn->Update();
  vtkPolyData* output = sewn->GetOutput();
  check.equal(std::string(sewn->GetStatusName()), std::string("Ok"), "status");
  check.equal(number(sewn->GetShapes(), "Pieces"), 2.0, "pieces of the one shape");
  check.equal(number(sewn->GetShapes(), "Pieces", 1), vtkMath::Inf(), "there is one shape");
  check.that(number(sewn->GetShapes(), "RelativeDistanceMax") < 0.005, "distance below 0.5 %");
  check.that(number(sewn->GetShapes(), "DistanceMax") > 0.0, "bending opens a tube, if by little");
  check.near(number(sewn->GetShapes(), "Size"),
    std::sqrt(2.0 * 24.0 * 2.0 * std::sin(vtkMath::Pi() / 24.0)), 1e-12, "Size, root of the area");
  vtkDataArray* pairs = output->GetFieldData()->GetArray("SeamPairs");
  vtkDataArray* strains = output->GetFieldData()->GetArray("SeamStrains");
  check.equal(pairs ? pairs->GetNumberOfTuples() : 0, 12, "edges sewn");
  for (vtkIdType row = 0; pairs && strains && row < pairs->GetNumberOfTuples(); ++row)
  {
    for (int end = 0; end < 2; ++end)
    {
      double a[3];
      double b[3];
      output->GetPoint(static_cast<vtkIdType>(pairs->GetComponent(row, end)), a);
      output->GetPoint(static_cast<vtkIdType>(pairs->GetComponent(row, 2 + end)), b);
      check.equal(vtkMath::Distance2BetweenPoints(a, b), 0.0, "a seam is shared");
      check.that(std::abs(strains->GetComponent(row, end)) < 1e-4, "a seam is not stretched");
    }
  }
}

void distancesAreThoseThatALocatorFinds(Checks& check)
{
  const auto dome = makeDome(1.0);
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

void unitsChangeNothing(Checks& check)
{
  double shares[2];
  for (int k = 0; k < 2; ++k)
  {
    vtkNew<vtkWireWarpingFilter> flattening;
    flattening->SetInputData(makeDome(k == 0 ? 1.0 : 1e6));
    vtkNew<vtkSewnShape> sewn;
    sewn->SetInputConnection(flattening->GetOutputPort(0));
    sewn->SetDesignConnection(flattening->GetOutputPort(2));
    sewn->Update();
    shares[k] = number(sewn->GetShapes(), "RelativeDistanceMean");
  }
  check.near(shares[1] / shares[0], 1.0, 1e-6, "share of the size");
}

void whatCannotBeSewnIsRefused(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> flattening;
  flattening->SetInputData(makeDome(1.0));
  flattening->Update();
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

  sewn->SetInputData(flattening->GetOutput(0));
  sewn->SetMaximumIterations(1);
  sewn->Update();
  check.equal(sewn->GetStatusCode(), static_cast<int>(vtkSewnShape::NOT_CONVERGED), "one step");
  check.contains(sewn->GetStatusMessage(), "MaximumIterations", "the way out");
  check.equal(text(sewn->GetShapes(), "Status"), std::string("NotConverged"), "row of the shape");
}
}

int TestSewnShape(int, char*[])
{
  Checks check;
  theDefaultsAreThoseOfCore(check);
  aTubeOfTwoPiecesComesBack(check);
  distancesAreThoseThatALocatorFinds(check);
  unitsChangeNothing(check);
  whatCannotBeSewnIsRefused(check);
  return check.result();
}
