// SPDX-License-Identifier: BSD-3-Clause
// What a filter keeps between updates changes no bit of the next result.
#include "FlatteningTesting.h"

#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
void move(vtkPolyData* data, vtkIdType p, const std::array<double, 3>& to)
{
  data->GetPoints()->SetPoint(p, to.data());
  data->GetPoints()->Modified();
}

void stretch(vtkPolyData* data)
{
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> x{};
    data->GetPoint(p, x.data());
    move(data, p, { x[0], 1.01 * x[1], x[2] });
  }
}

/// One filter that is updated after each change of its input, beside a new one each time.
class Comparison
{
public:
  Comparison(Checks& check, vtkPolyData* surfaceInput, vtkPolyData* curveInput, int interior)
    : Check(check)
  {
    this->surface->DeepCopy(surfaceInput);
    this->curves->DeepCopy(curveInput);
    this->filter->SetInputData(this->surface);
    this->filter->SetCurvesData(this->curves);
    this->filter->SetSchemeToGlobal();
    this->filter->SetInterior(interior);
    check.that(this->filter->GetCaching(), "keeps what it can unless told otherwise");
  }

  /// With what a new filter makes of the same. \return the status of both
  int compare(const std::string& what)
  {
    this->filter->Update();
    vtkNew<vtkWireWarpingFilter> forgets;
    const Messages others(forgets);
    forgets->CachingOff();
    forgets->SetInputData(this->filter->GetInput());
    forgets->SetCurvesData(this->curves);
    forgets->SetScheme(this->filter->GetScheme());
    forgets->SetInterior(this->filter->GetInterior());
    forgets->SetCoincidentPoints(this->filter->GetCoincidentPoints());
    forgets->SetSplitTriangles(this->filter->GetSplitTriangles());
    forgets->SetImprintTolerance(this->filter->GetImprintTolerance());
    forgets->SetSnapTolerance(this->filter->GetSnapTolerance());
    forgets->Update();
    this->Check.equal(this->filter->GetStatusCode(), forgets->GetStatusCode(), what + ": status");
    this->Check.equal(std::string(this->filter->GetStatusMessage()),
      std::string(forgets->GetStatusMessage()), what + ": message");
    for (int port = 0; port < 3; ++port)
    {
      samePoints(this->Check, this->filter->GetOutput(port), forgets->GetOutput(port), what);
      vtkPolyData* const kept = this->filter->GetOutput(port);
      vtkPolyData* const fresh = forgets->GetOutput(port);
      sameArrays(this->Check, kept->GetCellData(), fresh->GetCellData(), what);
      sameArrays(this->Check, kept->GetPointData(), fresh->GetPointData(), what);
      sameArrays(this->Check, kept->GetFieldData(), fresh->GetFieldData(), what);
    }
    return this->filter->GetStatusCode();
  }

  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPolyData> curves;
  vtkNew<vtkWireWarpingFilter> filter;

private:
  Checks& Check;
  const Messages Silent{ this->filter };
};

void noChangeIsMissed(Checks& check, vtkPolyData* surface, vtkPolyData* curves, int interior)
{
  Comparison run(check, surface, curves, interior);
  check.equal(run.compare("first update"), int{ vtkWireWarpingFilter::OK }, "is flattened");
  run.filter->SetSchemeToProgressive();
  run.compare("another scheme");
  run.filter->SetSchemeToGlobal();
  const auto ofFirstCurve = [](vtkDataArray* array, double value) {
    array->SetComponent(0, 0, value);
    array->Modified();
  };
  vtkDataArray* types = run.curves->GetCellData()->GetArray("CurveType");
  for (const double type : { 1.0, 2.0, 0.0, 3.0, 0.0 })
  {
    ofFirstCurve(types, type);
    run.compare("a curve of type " + std::to_string(static_cast<int>(type)));
  }
  const vtkIdType count = run.curves->GetNumberOfCells();
  const auto tolerances = filled<vtkDoubleArray>("LengthTolerance", 1, count, 0.02);
  run.curves->GetCellData()->AddArray(tolerances);
  run.compare("elastic curves");
  tolerances->Fill(0.0);
  tolerances->Modified();
  run.compare("rigid curves");
  const auto shapes = filled<vtkIntArray>("KeyShape", 1, count, 1);
  run.curves->GetCellData()->AddArray(shapes);
  ofFirstCurve(types, 1.0);
  run.compare("a straight key");
  auto* names =
    vtkStringArray::SafeDownCast(run.curves->GetCellData()->GetAbstractArray("CurveName"));
  check.that(names, "the curves have names");
  names->SetValue(0, "renamed");
  names->Modified();
  run.compare("another name");
  ofFirstCurve(shapes, 2.0);
  const auto planar =
    filled<vtkDoubleArray>("PlanarShape", 2, run.curves->GetNumberOfPoints(), 0.0);
  for (const double bend : { 0.0, 0.1 })
  {
    for (vtkIdType p = 0; p < run.curves->GetNumberOfPoints(); ++p)
    {
      const double x = static_cast<double>(p);
      planar->SetTuple2(p, x, bend * x * x / static_cast<double>(run.curves->GetNumberOfPoints()));
    }
    planar->Modified();
    run.curves->GetPointData()->AddArray(planar);
    run.compare("a planar shape with the bend " + std::to_string(bend));
  }
  ofFirstCurve(shapes, 1.0);
  ofFirstCurve(types, 9.0);
  check.equal(
    run.compare("no type of a curve"), int{ vtkWireWarpingFilter::INVALID_CURVE }, "is refused");
  ofFirstCurve(types, 0.0);
  check.equal(run.compare("a type again"), int{ vtkWireWarpingFilter::OK }, "is flattened");
}

/// Half-way between the first two points of the first curve.
std::array<double, 3> middleOfFirstSegment(vtkPolyData* curves, vtkIdType& second)
{
  vtkNew<vtkIdList> ids;
  curves->GetLines()->GetCellAtId(0, ids);
  second = ids->GetId(1);
  std::array<double, 3> a{};
  std::array<double, 3> b{};
  curves->GetPoint(ids->GetId(0), a.data());
  curves->GetPoint(second, b.data());
  return { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) };
}

void movedInputIsReadAnew(Checks& check, vtkPolyData* surface, vtkPolyData* curves, int interior)
{
  Comparison run(check, surface, curves, interior);
  run.compare("first update");
  stretch(run.surface);
  stretch(run.curves);
  run.compare("a surface that has moved");

  vtkIdType second = -1;
  const std::array<double, 3> middle = middleOfFirstSegment(run.curves, second);
  std::array<double, 3> before{};
  run.curves->GetPoint(second, before.data());
  const vtkIdType pointCount = run.filter->GetOutput()->GetNumberOfPoints();
  move(run.curves, second, middle);
  run.compare("a curve that has moved");
  run.filter->SetSnapTolerance(0.5);
  run.compare("another snap tolerance");
  run.filter->SplitTrianglesOff();
  run.compare("triangles that must not be split");
  run.filter->SplitTrianglesOn();
  run.filter->SetSnapTolerance(1e-3);
  std::array<double, 3> off = middle;
  off[2] += 0.01 * run.surface->GetLength();
  move(run.curves, second, off);
  check.equal(run.compare("a curve off the surface"),
    int{ vtkWireWarpingFilter::CURVE_POINT_OFF_SURFACE }, "is refused");
  move(run.curves, second, before);
  run.compare("the curve where it was");
  check.equal(run.filter->GetOutput()->GetNumberOfPoints(), pointCount, "no point is left over");

  // As many points and cells as before.
  vtkNew<vtkPolyData> other;
  other->DeepCopy(surface);
  stretch(other);
  move(other, 0, { other->GetPoint(0)[0], other->GetPoint(0)[1], other->GetPoint(0)[2] + 1e-9 });
  run.filter->SetInputData(other);
  run.compare("another surface");
  run.filter->SetCoincidentPointsToJoin();
  run.compare("coincident points joined");
}

/// Data sets may share points, whose time is then the time of all.
void surfacesThatSharePointsAreToldApart(Checks& check, vtkPolyData* surface)
{
  vtkNew<vtkPolyData> whole;
  whole->DeepCopy(surface);
  vtkNew<vtkPolyData> half;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < whole->GetNumberOfCells() / 2; ++c)
  {
    whole->GetCellPoints(c, ids);
    cells->InsertNextCell(ids);
  }
  half->SetPoints(whole->GetPoints());
  half->SetPolys(cells);
  whole->GetPoints()->Modified();
  check.equal(whole->GetMTime(), half->GetMTime(), "both have one time");
  vtkNew<vtkWireWarpingFilter> filter;
  for (vtkPolyData* input : { whole.Get(), half.Get(), whole.Get() })
  {
    filter->SetInputData(input);
    filter->Update();
    check.equal(filter->GetOutput()->GetNumberOfCells(), input->GetNumberOfCells(),
      "each surface is read for itself");
  }
}
}

int TestWireWarpingFilterCaching(int argc, char* argv[])
{
  const std::string data = dataDirectory(argc, argv);
  Checks check;
  const auto surface = read(data + "/shirt_shoulder.vtp");
  check.that(surface->GetNumberOfPolys() > 100, "the piece is read from " + data);
  const auto curves = read(data + "/shirt_shoulder_curves.vtp");
  surfacesThatSharePointsAreToldApart(check, surface);
  for (const int interior :
    { vtkWireWarpingFilter::LAPLACIAN, vtkWireWarpingFilter::AS_RIGID_AS_POSSIBLE })
  {
    noChangeIsMissed(check, surface, curves, interior);
    movedInputIsReadAnew(check, surface, curves, interior);
  }
  return check.result();
}
