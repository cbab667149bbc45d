// SPDX-License-Identifier: BSD-3-Clause
// What line cells mean as feature curves: types by number and name, names, own lines, several data
// sets, and two-point lines. Curves across the mesh become edges; cuts whose result can be counted
// by hand.
#include "FlatteningTesting.h"
#include "vtkFeatureCurveCutter.h"
#include "vtkFeatureCurveImprinter.h"
#include "vtkFeatureEdges.h"
#include "vtkTrivialProducer.h"
#include "vtkWireWarpingFilter.h"

#include <map>

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

/// Two crossing polylines over the unit square with names, types and an array of the user's own.
vtkSmartPointer<vtkPolyData> makeCrossing()
{
  const auto curves = makePolyData({ { 0.05, 0.1, 0 }, { 0.5, 0.52, 0 }, { 0.93, 0.88, 0 },
                                     { 0.1, 0.9, 0 }, { 0.45, 0.47, 0 }, { 0.9, 0.07, 0 } },
    {});
  addLine(curves, { 0, 1, 2 });
  addLine(curves, { 3, 4, 5 });
  curves->GetCellData()->AddArray(
    arrayOf<vtkStringArray>("CurveType", std::vector<std::string>{ "key", "accessory" }));
  curves->GetCellData()->AddArray(
    arrayOf<vtkDoubleArray>("Thread", std::vector<double>{ 7.5, 8.5 }));
  return curves;
}

double length(vtkPolyData* lines, vtkIdType line)
{
  vtkNew<vtkIdList> ids;
  lines->GetLines()->GetCellAtId(line, ids);
  double sum = 0.0;
  for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
  {
    double a[3];
    double b[3];
    lines->GetPoint(ids->GetId(i - 1), a);
    lines->GetPoint(ids->GetId(i), b);
    sum += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
  }
  return sum;
}

void dataOfTheInputComeAlong(Checks& check)
{
  const auto grid = makeGrid(7, 5);
  const auto linear = [](const double* x) { return 2.0 * x[0] - 3.0 * x[1] + 1.0; };
  // Reproduced exactly by linear interpolation.
  grid->GetPointData()->AddArray(arrayOf<vtkDoubleArray>(
    "Linear", grid->GetNumberOfPoints(), [&](vtkIdType p) { return linear(grid->GetPoint(p)); }));
  grid->GetCellData()->AddArray(arrayOf<vtkIntArray>(
    "Label", grid->GetNumberOfCells(), [](vtkIdType t) { return static_cast<int>(1000 + t); }));
  const auto filter = updated<vtkFeatureCurveImprinter>(grid, makeCrossing());
  vtkPolyData* surface = filter->GetOutput(0);
  vtkDataArray* values = surface->GetPointData()->GetArray("Linear");
  auto* points =
    vtkIdTypeArray::SafeDownCast(surface->GetPointData()->GetArray("vtkOriginalPointIds"));
  auto* cells =
    vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetArray("vtkOriginalCellIds"));
  vtkDataArray* labels = surface->GetCellData()->GetArray("Label");
  check.that(values && points && cells && labels, "arrays are there");
  if (!values || !points || !cells || !labels)
  {
    return;
  }
  check.that(surface->GetNumberOfPoints() > grid->GetNumberOfPoints(), "there are new points");
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    check.near(values->GetComponent(p, 0), linear(surface->GetPoint(p)), 1e-14, "point data");
    const vtkIdType expected = p < grid->GetNumberOfPoints() ? p : -1;
    check.equal(points->GetValue(p), expected, "original point");
  }
  for (vtkIdType t = 0; t < surface->GetNumberOfCells(); ++t)
  {
    check.equal(labels->GetComponent(t, 0), 1000.0 + cells->GetValue(t), "cell data");
    // The middle of a part lies in the square of its whole.
    double x[3] = { 0, 0, 0 };
    vtkIdList* ids = surface->GetCell(t)->GetPointIds();
    for (int k = 0; k < 3; ++k)
    {
      double p[3];
      surface->GetPoint(ids->GetId(k), p);
      vtkMath::Add(x, p, x);
    }
    const vtkIdType square =
      static_cast<vtkIdType>(x[0] / 3.0 * 7) + 7 * static_cast<vtkIdType>(x[1] / 3.0 * 5);
    check.equal(cells->GetValue(t) / 2, square, "square of a triangle");
  }

  vtkCellData* ofCurves = filter->GetOutput(1)->GetCellData();
  vtkDataArray* type = ofCurves->GetArray("CurveType");
  vtkDataArray* thread = ofCurves->GetArray("Thread");
  vtkDataArray* rest = ofCurves->GetArray("RestLength");
  check.that(type && thread && rest, "cell arrays of the curves are there");
  if (type && thread && rest)
  {
    check.equal(type->GetComponent(0, 0), 1.0, "type of the key curve");
    check.equal(type->GetComponent(1, 0), 0.0, "type of the accessory curve");
    check.equal(thread->GetComponent(1, 0), 8.5, "an array of the user's own");
    check.near(rest->GetComponent(0, 0), length(filter->GetOutput(1), 0), 1e-15, "RestLength");
  }
}

// Arrays that only some of several data sets have are left out; those of all are kept.
void severalDataSetsOfCurvesGiveTheirCommonArrays(Checks& check)
{
  const auto one = makeCrossing();
  const auto two = makePolyData({ { 0.2, 0.3, 0 }, { 0.8, 0.35, 0 } }, {});
  addLine(two, { 0, 1 });
  two->GetCellData()->AddArray(filled<vtkDoubleArray>("Thread", 1, 1, 9.5));
  two->GetCellData()->AddArray(filled<vtkDoubleArray>("Alone", 1, 1, 1.0));
  vtkNew<vtkFeatureCurveImprinter> filter;
  filter->SetInputData(makeGrid(3, 3));
  filter->AddInputData(1, one);
  filter->AddInputData(1, two);
  filter->Update();
  vtkPolyData* curves = filter->GetOutput(1);
  check.equal(curves->GetNumberOfLines(), 3, "number of curves");
  vtkDataArray* values = curves->GetCellData()->GetArray("Thread");
  check.that(values && values->GetComponent(2, 0) == 9.5, "the common array");
  check.that(!curves->GetCellData()->HasArray("Alone"), "an array of one data set only");
}

// What the imprinter gives flattens like what the main filter imprints itself.
void theOutputsCanBeFlattened(Checks& check)
{
  const auto grid = makeGrid(8, 8, [](double x, double y) { return 0.1 * x * y; });
  const auto curves = makePolyData({ { 0.0, 0.31, 0 }, { 1.0, 0.31, 0.031 } }, {});
  addLine(curves, { 0, 1 });
  vtkNew<vtkFeatureCurveImprinter> imprinter;
  imprinter->SetInputData(grid);
  imprinter->SetCurvesData(curves);
  imprinter->SetImprintTolerance(0.01);
  vtkNew<vtkWireWarpingFilter> after;
  after->SetInputConnection(imprinter->GetOutputPort(0));
  after->SetCurvesConnection(imprinter->GetOutputPort(1));
  after->Update();
  vtkNew<vtkWireWarpingFilter> direct;
  direct->SetInputData(grid);
  direct->SetCurvesData(curves);
  direct->SetImprintTolerance(0.01);
  direct->Update();
  check.equal(std::string(after->GetStatusName()), std::string(direct->GetStatusName()), "status");
  check.that(after->GetOutput()->GetNumberOfPoints() > grid->GetNumberOfPoints(), "new points");
  check.near(number(after, "Objective"), number(direct, "Objective"), 1e-12, "objective");
  check.near(largestLengthError(after->GetOutput(1), after->GetOutput()->GetPoints(),
               after->GetOutput(2)->GetPoints()),
    0.0, 1e-9, "length error");
}

// A dart from the boundary to the middle of a 4 x 4 grid: its points get two copies, its tip one.
void aDartOpens(Checks& check)
{
  const auto grid = makeGrid(4, 4);
  const auto cutter = updated<vtkFeatureCurveCutter>(
    grid, makeCurves(grid, { { 2, 7, 12 } }, { vtkFeatureCurveCutter::DART }));
  vtkPolyData* cut = cutter->GetOutput();
  check.equal(cut->GetNumberOfPoints(), 27, "points with an open dart");
  std::map<double, int> copies;
  for (vtkIdType p = 0; p < cut->GetNumberOfPoints(); ++p)
  {
    ++copies[cut->GetPointData()->GetArray("vtkOriginalPointIds")->GetComponent(p, 0)];
  }
  for (const auto& [point, count] : copies)
  {
    check.equal(
      count, point == 2 || point == 7 ? 2 : 1, "copies of point " + std::to_string(point));
  }
  check.equal(cut->GetFieldData()->GetArray("SeamPairs")->GetNumberOfTuples(), 2, "seam pairs");
  double range[2];
  cut->GetCellData()->GetArray("PieceId")->GetRange(range);
  check.equal(range[1], 0.0, "a dart leaves one piece");

  vtkPolyData* wires = cutter->GetOutput(1);
  check.equal(wires->GetNumberOfPoints(), cut->GetNumberOfPoints(), "wires share the points");
  double dart = 0.0;
  double boundary = 0.0;
  for (vtkIdType w = 0; w < wires->GetNumberOfLines(); ++w)
  {
    check.equal(cellValue(wires, "Boundary", w), 1.0, "the wire is boundary");
    (cellValue(wires, "CurveType", w) == 2.0 ? dart : boundary) +=
      cellValue(wires, "RestLength", w);
  }
  check.near(dart, 2 * 0.5, 1e-12, "length of both sides of the dart");
  check.near(boundary, 4.0, 1e-12, "length of the square's boundary");
}
}

int TestFeatureCurves(int, char*[])
{
  Checks check;
  typesMayBeNumbersOrNames(check);
  curvesComeFromSeveralDataSets(check);
  twoPointLinesAreJoined(check);
  namesKeepTwoPointLinesApart(check);
  tolerancesMayBeGivenByName(check);
  aClosedCurveMayComeInEdges(check);
  featureEdgesAreCurves(check);
  dataOfTheInputComeAlong(check);
  severalDataSetsOfCurvesGiveTheirCommonArrays(check);
  theOutputsCanBeFlattened(check);
  aDartOpens(check);
  return check.result();
}
