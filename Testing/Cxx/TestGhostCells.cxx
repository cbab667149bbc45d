// SPDX-License-Identifier: BSD-3-Clause
// Ghost cells: copies of other processes' cells and hidden ones are left out, ids stay the input's.
#include "FlatteningTesting.h"

#include "vtkDataSetAttributes.h"
#include "vtkFeatureCurveCutter.h"
#include "vtkFeatureCurveImprinter.h"
#include "vtkFlatteningQuality.h"
#include "vtkLeastSquaresConformalFilter.h"
#include "vtkSurfaceDevelopability.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
constexpr int columns = 6;
constexpr int rows = 5;
constexpr unsigned char duplicate = vtkDataSetAttributes::DUPLICATECELL;
constexpr unsigned char hidden = vtkDataSetAttributes::HIDDENCELL;

double height(double x, double y)
{
  return 0.3 * std::sin(2.0 * x) * std::cos(3.0 * y);
}

/// Marks cells by what a function says of their number; null data: all are read.
void mark(vtkPolyData* data, const std::function<unsigned char(vtkIdType)>& markOf)
{
  data->GetCellData()->AddArray(arrayOf<vtkUnsignedCharArray>(
    vtkDataSetAttributes::GhostArrayName(), data->GetNumberOfCells(), markOf));
}

/// The grid as triangles, quads or strips, each of one column or row less than the next.
vtkSmartPointer<vtkPolyData> sheet(int kind)
{
  auto grid = makeGrid(columns, rows, height);
  if (kind == 0)
  {
    return grid;
  }
  vtkNew<vtkCellArray> cells;
  const vtkIdType line = columns + 1;
  for (vtkIdType j = 0; j < rows; ++j)
  {
    Cell strip;
    for (vtkIdType i = 0; i <= columns; ++i)
    {
      const vtkIdType a = j * line + i;
      strip.push_back(a + line);
      strip.push_back(a);
      if (kind == 1 && i < columns)
      {
        const vtkIdType quad[4] = { a, a + 1, a + 1 + line, a + line };
        cells->InsertNextCell(4, quad);
      }
    }
    if (kind == 2)
    {
      cells->InsertNextCell(static_cast<vtkIdType>(strip.size()), strip.data());
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(grid->GetPoints());
  if (kind == 1)
  {
    result->SetPolys(cells);
  }
  else
  {
    result->SetStrips(cells);
  }
  return result;
}

/// The first rows of a sheet, without the rest.
vtkSmartPointer<vtkPolyData> part(vtkPolyData* whole, vtkIdType cells)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(whole->GetPoints());
  vtkNew<vtkCellArray> kept;
  vtkNew<vtkIdList> ids;
  for (vtkIdType k = 0; k < cells; ++k)
  {
    whole->GetCellPoints(k, ids);
    kept->InsertNextCell(ids);
  }
  if (whole->GetNumberOfStrips() > 0)
  {
    result->SetStrips(kept);
  }
  else
  {
    result->SetPolys(kept);
  }
  return result;
}

template <class Filter>
vtkSmartPointer<Filter> run(vtkPolyData* input)
{
  return updated<Filter>(input);
}

template <>
vtkSmartPointer<vtkFlatteningQuality> run(vtkPolyData* input)
{
  auto filter = vtkSmartPointer<vtkFlatteningQuality>::New();
  filter->SetInputData(input);
  filter->SetFlatData(input);
  filter->Update();
  return filter;
}

template <class Filter>
void ghostsAreLeftOut(Checks& checks, const std::string& name)
{
  for (int kind = 0; kind < 3; ++kind)
  {
    for (const unsigned char ghost : { duplicate, hidden })
    {
      const auto whole = sheet(kind);
      const vtkIdType kept = whole->GetNumberOfCells() * 3 / rows;
      const auto expected = run<Filter>(part(whole, kept));
      mark(whole, [&](vtkIdType k) { return k < kept ? 0 : ghost; });
      const auto filter = run<Filter>(whole);
      const std::string what = name + ", kind " + std::to_string(kind);
      checks.that(!filter->IsRefused(), what + ": no refusal");
      vtkPolyData* a = filter->GetOutput();
      vtkPolyData* b = expected->GetOutput();
      checks.equal(a->GetNumberOfCells(), b->GetNumberOfCells(), what + ": cells");
      checks.that(a->GetNumberOfCells() > 0, what + ": there are cells");
      samePoints(checks, a, b, what);
    }
  }
}

void idsAreThoseOfTheInput(Checks& checks)
{
  // The first cells are ghosts, and two lines go before all of them.
  const auto grid = makeGrid(columns, rows, height);
  addLine(grid, { 14, 15, 16 });
  addLine(grid, { 21, 22, 23, 24 });
  const vtkIdType ghosts = 2 * columns;
  mark(grid, [&](vtkIdType k) {
    return k == 1 || (k >= 2 && k < 2 + ghosts) ? duplicate : static_cast<unsigned char>(0);
  });
  const auto filter = run<vtkWireWarpingFilter>(grid);
  vtkPolyData* flat = filter->GetOutput();
  vtkDataArray* cells = flat->GetCellData()->GetArray("vtkOriginalCellIds");
  checks.equal(flat->GetNumberOfCells(), vtkIdType{ 2 * columns * (rows - 1) }, "cells");
  for (vtkIdType k = 0; k < flat->GetNumberOfCells(); ++k)
  {
    checks.equal(cells->GetComponent(k, 0), double(2 + ghosts + k), "vtkOriginalCellIds");
  }
  checks.equal(flat->GetPointData()->GetArray("vtkOriginalPointIds")->GetRange()[0],
    double(columns + 1), "points of ghosts alone are not there");
  checks.equal(
    filter->GetCurves()->GetNumberOfRows(), vtkIdType{ 1 }, "a line that is a ghost is no curve");
}

/// Around a point at the border of a process the copies of the neighbour's cells count.
void developabilityNeedsDuplicates(Checks& checks)
{
  const auto whole = sheet(0);
  const auto expected = run<vtkSurfaceDevelopability>(whole);
  const vtkIdType kept = 2 * columns * 3;
  mark(whole, [&](vtkIdType k) { return k < kept ? 0 : duplicate; });
  const auto filter = run<vtkSurfaceDevelopability>(whole);
  vtkDataArray* a = filter->GetOutput()->GetPointData()->GetArray("Developability");
  vtkDataArray* b = expected->GetOutput()->GetPointData()->GetArray("Developability");
  for (vtkIdType p = 0; p < whole->GetNumberOfPoints(); ++p)
  {
    checks.equal(a->GetComponent(p, 0), b->GetComponent(p, 0), "Developability");
  }
  checks.that(b->GetComponent(3 * (columns + 1) + 2, 0) > 1e-6, "the border is curved");

  mark(whole, [&](vtkIdType k) { return k < kept ? 0 : hidden; });
  const auto cut = run<vtkSurfaceDevelopability>(whole);
  checks.equal(cut->GetOutput()
                 ->GetPointData()
                 ->GetArray("Developability")
                 ->GetComponent(3 * (columns + 1) + 2, 0),
    0.0, "beside hidden cells is the boundary");
}

void aChangeOfGhostsIsSeenByTheCache(Checks& checks)
{
  const auto grid = makeGrid(columns, rows, height);
  const auto filter = updated<vtkWireWarpingFilter>(grid);
  checks.equal(filter->GetOutput()->GetNumberOfCells(), vtkIdType{ 60 }, "all cells");
  mark(grid, [](vtkIdType k) { return k < 48 ? 0 : duplicate; });
  filter->Update();
  checks.equal(filter->GetOutput()->GetNumberOfCells(), vtkIdType{ 48 }, "without ghosts");
  grid->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  filter->Update();
  checks.equal(filter->GetOutput()->GetNumberOfCells(), vtkIdType{ 60 }, "all cells again");
}

void ghostsAloneAreNoSurface(Checks& checks)
{
  const auto grid = makeGrid(columns, rows);
  mark(grid, [](vtkIdType) { return duplicate; });
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(grid);
  filter->Update();
  checks.equal(std::string(filter->GetStatusName()), std::string("EmptySurface"), "ghosts alone");
}
}

int TestGhostCells(int, char*[])
{
  Checks checks;
  ghostsAreLeftOut<vtkWireWarpingFilter>(checks, "vtkWireWarpingFilter");
  ghostsAreLeftOut<vtkLeastSquaresConformalFilter>(checks, "vtkLeastSquaresConformalFilter");
  ghostsAreLeftOut<vtkFeatureCurveCutter>(checks, "vtkFeatureCurveCutter");
  ghostsAreLeftOut<vtkFeatureCurveImprinter>(checks, "vtkFeatureCurveImprinter");
  ghostsAreLeftOut<vtkFlatteningQuality>(checks, "vtkFlatteningQuality");
  idsAreThoseOfTheInput(checks);
  developabilityNeedsDuplicates(checks);
  aChangeOfGhostsIsSeenByTheCache(checks);
  ghostsAloneAreNoSurface(checks);
  return checks.result();
}
