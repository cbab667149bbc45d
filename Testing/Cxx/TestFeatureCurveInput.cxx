// SPDX-License-Identifier: BSD-3-Clause
// What line cells mean as feature curves: types by number and name, names, own lines, several data
// sets, and two-point lines.
#include "FlatteningTesting.h"

#include "vtkFeatureEdges.h"
#include "vtkTrivialProducer.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
vtkIdType curveCount(vtkWireWarpingFilter* filter)
{
  return filter->GetCurves()->GetNumberOfRows();
}

void typesMayBeNumbersOrNames(Checks& check)
{
  const auto grid = makeGrid(4, 4);
  const std::vector<Cell> lines = { { 10, 11, 12 }, { 2, 7 }, { 14, 13 }, { 15, 16, 17, 18, 19 } };
  const auto byNumber = makeCurves(grid, lines, { 0, 1, 2, 3 });
  const auto byName = makeCurves(grid, lines);
  const std::vector<std::string> types{ "accessory", "key", "dart", "seam" };
  byName->GetCellData()->AddArray(arrayOf<vtkStringArray>("CurveType", types));
  for (vtkPolyData* curves : { byNumber.Get(), byName.Get() })
  {
    const auto filter = updated<vtkWireWarpingFilter>(grid, curves);
    check.equal(std::string(filter->GetStatusName()), "Ok", "status");
    check.equal(curveCount(filter), 4, "number of curves");
    for (int c = 0; c < 4; ++c)
    {
      check.equal(text(filter->GetCurves(), "Type", c), types[c], "type");
      check.equal(
        text(filter->GetCurves(), "Name", c), "curve " + std::to_string(c), "default name");
    }
    check.equal(filter->GetPieces()->GetNumberOfRows(), 2, "the seam makes two pieces");
  }
}

// Own lines first, then each connection of port 1.
void curvesComeFromSeveralDataSets(Checks& check)
{
  const auto grid = makeGrid(4, 4);
  addLine(grid, { 10, 11, 12, 13, 14 });
  const auto first = makeCurves(grid, { { 2, 7, 12 } });
  first->GetCellData()->AddArray(filled<vtkStringArray>("CurveName", 1, 1, "waist"));
  const auto second = makeCurves(grid, { { 22, 17, 12 } });
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetInputData(grid);
  for (vtkPolyData* curves : { first.Get(), second.Get() })
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(curves);
    filter->AddCurvesConnection(producer->GetOutputPort());
  }
  filter->Update();
  check.equal(std::string(filter->GetStatusName()), "Ok", "status");
  check.equal(curveCount(filter), 3, "number of curves");
  check.equal(text(filter->GetCurves(), "Name", 0), "curve 0", "the surface's own curve");
  check.equal(text(filter->GetCurves(), "Name", 1), "waist", "the first connection's");
  check.equal(text(filter->GetCurves(), "Name", 2), "curve 2", "the second connection's");
  check.equal(number(filter, "WirePatches"), 4.0, "wire-patches");
  check.equal(
    filter->GetOutput()->GetNumberOfLines(), 0, "own lines are no part of the flat piece");
  check.equal(filter->GetOutput()->GetNumberOfPolys(), 32, "triangles");
}

// Nine edges in any order and direction, four of another type: two chains.
void twoPointLinesAreJoined(Checks& check)
{
  const auto grid = makeGrid(4, 4);
  const auto curves = makeCurves(grid,
    { { 12, 13 }, { 2, 7 }, { 11, 10 }, { 13, 14 }, { 12, 7 }, { 11, 12 } }, { 0, 2, 0, 0, 2, 0 });
  const auto filter = updated<vtkWireWarpingFilter>(grid, curves);
  check.equal(std::string(filter->GetStatusName()), "Ok", "status");
  check.equal(curveCount(filter), 2, "number of curves");
  check.near(number(filter->GetCurves(), "RestLength", 0), 1.0, 1e-12, "the accessory curve");
  check.equal(text(filter->GetCurves(), "Type", 1), "dart", "the second is the dart");
  check.near(number(filter->GetCurves(), "RestLength", 1), 0.5, 1e-12, "the dart");
}

void namesKeepTwoPointLinesApart(Checks& check)
{
  const auto grid = makeGrid(4, 4);
  const auto curves = makeCurves(grid, { { 10, 11 }, { 11, 12 }, { 12, 13 }, { 13, 14 } });
  curves->GetCellData()->AddArray(arrayOf<vtkStringArray>(
    "CurveName", std::vector<std::string>{ "left", "left", "right", "right" }));
  const auto filter = updated<vtkWireWarpingFilter>(grid, curves);
  check.equal(curveCount(filter), 2, "number of curves");
  check.equal(text(filter->GetCurves(), "Name", 0), "left", "first name");
  check.equal(text(filter->GetCurves(), "Name", 1), "right", "second name");
  check.near(number(filter->GetCurves(), "RestLength", 1), 0.5, 1e-12, "its length");
}

// By the names of the report, also where the caller gave none; an update takes them back.
void tolerancesMayBeGivenByName(Checks& check)
{
  const auto grid = makeGrid(4, 4);
  const auto curves = makeCurves(grid, { { 10, 11 }, { 11, 12 }, { 2, 7, 12 } });
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(grid);
  filter->SetCurvesData(curves);
  filter->AddCurveTolerance("curve 1", 0.02);
  filter->Update();
  check.equal(curveCount(filter), 2, "number of curves");
  check.equal(number(filter->GetCurves(), "Tolerance", 0), 0.0, "the other's tolerance");
  check.equal(number(filter->GetCurves(), "Tolerance", 1), 0.02, "tolerance");
  filter->RemoveAllCurveTolerances();
  filter->Update();
  check.equal(number(filter->GetCurves(), "Tolerance", 1), 0.0, "tolerance, removed");
  filter->AddCurveTolerance("belt", 0.1);
  filter->Update();
  check.equal(std::string(filter->GetStatusName()), "InvalidOption", "a name of no curve");
  check.contains(filter->GetStatusMessage(), "the curves are curve 0, curve 1", "message");
}

// A closed curve, once as one polyline and once as its edges.
void aClosedCurveMayComeInEdges(Checks& check)
{
  const auto grid = makeGrid(4, 4);
  const Cell loop = { 6, 7, 8, 13, 18, 17, 16, 11, 6 };
  std::vector<Cell> edges;
  for (std::size_t i = 1; i < loop.size(); ++i)
  {
    edges.push_back({ loop[i - 1], loop[i] });
  }
  for (const std::vector<Cell>& lines : { std::vector<Cell>{ loop }, edges })
  {
    const auto filter = updated<vtkWireWarpingFilter>(grid, makeCurves(grid, lines));
    check.equal(std::string(filter->GetStatusName()), "Ok", "status");
    check.equal(curveCount(filter), 1, "number of curves");
    check.near(number(filter->GetCurves(), "RestLength"), 2.0, 1e-12, "length of the loop");
  }
}

// The output of vtkFeatureEdges on a folded sheet is a curve as it is.
void featureEdgesAreCurves(Checks& check)
{
  const auto roof = makeGrid(4, 4, [](double x, double) { return -std::abs(x - 0.5); });
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(roof);
  edges->BoundaryEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->SetFeatureAngle(30.0);
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetInputData(roof);
  filter->SetCurvesConnection(edges->GetOutputPort());
  filter->Update();
  check.equal(std::string(filter->GetStatusName()), "Ok", "status");
  check.equal(curveCount(filter), 1, "number of curves");
  check.near(number(filter->GetCurves(), "RestLength"), 1.0, 1e-6, "length of the ridge");
  check.near(number(filter, "AreaError"), 0.0, 1e-6, "a roof unrolls: E_area");
}

}

int TestFeatureCurveInput(int, char*[])
{
  Checks check;
  typesMayBeNumbersOrNames(check);
  curvesComeFromSeveralDataSets(check);
  twoPointLinesAreJoined(check);
  namesKeepTwoPointLinesApart(check);
  tolerancesMayBeGivenByName(check);
  aClosedCurveMayComeInEdges(check);
  featureEdgesAreCurves(check);
  return check.result();
}
