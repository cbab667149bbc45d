// SPDX-License-Identifier: BSD-3-Clause
// SkipClosed: what cannot be laid flat is left out and named, the rest keeps its ids and arrays.
#include "FlatteningTesting.h"

#include "vtkAppendPolyData.h"
#include "vtkLeastSquaresConformalFilter.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
/// A strip that turns by more than a whole turn about an axis as it climbs: flat it lies on itself.
vtkSmartPointer<vtkPolyData> stairs()
{
  std::vector<std::array<double, 3>> points;
  std::vector<Cell> triangles;
  const int steps = 40;
  for (int k = 0; k <= steps; ++k)
  {
    const double angle = 2.6 * vtkMath::Pi() * k / steps;
    for (const double radius : { 0.6, 1.0 })
    {
      points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.02 * k + 5.0 });
    }
    if (k > 0)
    {
      const vtkIdType a = 2 * k - 2;
      triangles.push_back({ a, a + 1, a + 3 });
      triangles.push_back({ a, a + 3, a + 2 });
    }
  }
  return makePolyData(points, triangles);
}

/// The parts as one, each point and cell with its id as an array.
vtkSmartPointer<vtkPolyData> together(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const auto& part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  vtkSmartPointer<vtkPolyData> result = append->GetOutput();
  result->GetCellData()->AddArray(arrayOf<vtkIntArray>(
    "CellNumber", result->GetNumberOfCells(), [](vtkIdType k) { return static_cast<int>(k); }));
  result->GetPointData()->AddArray(arrayOf<vtkDoubleArray>("PointNumber",
    result->GetNumberOfPoints(), [](vtkIdType k) { return static_cast<double>(k); }));
  return result;
}

vtkSmartPointer<vtkPolyData> shirtWithButtons()
{
  const auto wave = [](double x, double y) { return 0.2 * std::sin(3.0 * x + y); };
  return together({ makeCube(10.0), makeGrid(5, 4, wave), makeCube(20.0), stairs() });
}

constexpr vtkIdType cubeCells = 6;
constexpr vtkIdType gridCells = 2 * 5 * 4;

void everyRowIsThatOfItsOriginal(Checks& checks, vtkPolyData* input, vtkPolyData* output)
{
  vtkDataArray* cells = output->GetCellData()->GetArray("vtkOriginalCellIds");
  vtkDataArray* points = output->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* cellNumbers = output->GetCellData()->GetArray("CellNumber");
  vtkDataArray* pointNumbers = output->GetPointData()->GetArray("PointNumber");
  bool same = true;
  for (vtkIdType k = 0; k < output->GetNumberOfCells(); ++k)
  {
    const auto cell = static_cast<vtkIdType>(cells->GetComponent(k, 0));
    same = same && cellNumbers->GetComponent(k, 0) == static_cast<double>(cell);
    // The same corners, since these are triangles.
    vtkNew<vtkIdList> before;
    vtkNew<vtkIdList> after;
    input->GetCellPoints(cell, before);
    output->GetCellPoints(k, after);
    for (vtkIdType corner = 0; corner < 3; ++corner)
    {
      const double id = points->GetComponent(after->GetId(corner), 0);
      same = same && before->IsId(static_cast<vtkIdType>(id)) >= 0;
    }
  }
  for (vtkIdType k = 0; k < output->GetNumberOfPoints(); ++k)
  {
    same = same && pointNumbers->GetComponent(k, 0) == points->GetComponent(k, 0);
  }
  checks.that(same, "cells, points and their arrays are those that the original ids say");
}

template <class Filter>
void theRestIsFlattened(Checks& checks)
{
  const auto input = shirtWithButtons();
  vtkNew<Filter> filter;
  const Messages messages(filter);
  filter->SetInputData(input);
  filter->SkipClosedOn();
  filter->Update();
  vtkPolyData* flat = filter->GetOutput();
  checks.equal(std::string(filter->GetStatusName()), std::string("Overlap"), "the stairs' status");
  checks.equal(text(flat, "RunStatus"), std::string("Overlap"), "RunStatus");
  checks.that(filter->GetStatusIds()->GetNumberOfValues() > 0, "the stairs' triangles are named");
  for (vtkIdType k = 0; k < filter->GetStatusIds()->GetNumberOfValues(); ++k)
  {
    checks.that(filter->GetStatusIds()->GetValue(k) >= 2 * cubeCells + gridCells,
      "ids of the overlap are cells of the stairs");
  }
  checks.equal(messages.errors.size(), std::size_t{ 0 }, "errors");
  checks.equal(messages.warnings.size(), std::size_t{ 2 }, "warnings");
  checks.equal(flat->GetNumberOfCells(), input->GetNumberOfCells() - 2 * cubeCells, "cells");
  checks.equal(flat->GetNumberOfPoints(), input->GetNumberOfPoints() - 2 * 8, "points");
  everyRowIsThatOfItsOriginal(checks, input, flat);
  everyRowIsThatOfItsOriginal(checks, input, filter->GetOutput(2));

  vtkTable* leftOut = filter->GetLeftOutPieces();
  checks.equal(leftOut->GetNumberOfRows(), vtkIdType{ 2 }, "pieces left out");
  checks.equal(number(leftOut, "Cell", 0), 0.0, "the first cube");
  checks.equal(number(leftOut, "Cell", 1), double{ cubeCells + gridCells }, "the second cube");
  checks.equal(number(leftOut, "Triangles", 1), 12.0, "six quads as triangles");
  checks.equal(text(leftOut, "Reason"), std::string("ClosedSurface"), "the reason");
  vtkStringArray* warnings = filter->GetStatusWarnings();
  checks.equal(warnings->GetNumberOfValues(), vtkIdType{ 1 }, "warnings beside the status");
  checks.contains(warnings->GetValue(0), "2 of 4 pieces", "the warning");
  checks.contains(warnings->GetValue(0), "cells 0, 46", "the warning");
  checks.equal(filter->GetPieces()->GetNumberOfRows(), vtkIdType{ 2 }, "rows of pieces");

  filter->SkipClosedOff();
  filter->Update();
  checks.equal(std::string(filter->GetStatusName()), std::string("ClosedSurface"), "the refusal");
  checks.equal(filter->GetStatusIds()->GetNumberOfValues(), vtkIdType{ 2 }, "both cubes' ids");
  checks.contains(filter->GetStatusMessage(), "cells 0, 46", "the refusal");
  checks.equal(filter->GetOutput()->GetNumberOfPoints(), vtkIdType{ 0 }, "points of a refusal");
  filter->SkipClosedOn();
  filter->Update();
  checks.equal(filter->GetOutput()->GetNumberOfCells(), input->GetNumberOfCells() - 2 * cubeCells,
    "cells when skipped again");
}
}

int TestSkippedPieces(int, char*[])
{
  Checks checks;
  theRestIsFlattened<vtkWireWarpingFilter>(checks);
  theRestIsFlattened<vtkLeastSquaresConformalFilter>(checks);
  return checks.result();
}
