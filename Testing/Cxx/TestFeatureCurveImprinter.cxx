// SPDX-License-Identifier: BSD-3-Clause
// Curves across the mesh become edges: lengths, data of the input, refusals, and the way on to the
// flattening.
#include "FlatteningTesting.h"

#include "vtkFeatureCurveImprinter.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
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
}

int TestFeatureCurveImprinter(int, char*[])
{
  Checks check;
  dataOfTheInputComeAlong(check);
  severalDataSetsOfCurvesGiveTheirCommonArrays(check);
  theOutputsCanBeFlattened(check);
  return check.result();
}
