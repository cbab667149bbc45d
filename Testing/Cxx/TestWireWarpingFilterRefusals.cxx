// SPDX-License-Identifier: BSD-3-Clause
// Bad input: one error that names the defect, the ids of the input and the remedy; empty outputs,
// but for a row in the table of pieces.
#include "FlatteningTesting.h"

#include "vtkWireWarpingFilter.h"

#include <limits>
#include <set>

using namespace flatteningTesting;

namespace
{
using Ids = std::set<vtkIdType>;

class Refusals
{
public:
  explicit Refusals(Checks& checks)
    : Check(checks)
  {
  }

  /// Expects a refusal with a status, ids of the input, and words in the message.
  void expect(
    const std::string& what, vtkPolyData* surface, vtkPolyData* curves, const std::string& status,
    const Ids& ids, const std::string& words,
    const std::function<void(vtkWireWarpingFilter*)>& setUp = [](vtkWireWarpingFilter*) {})
  {
    vtkNew<vtkWireWarpingFilter> filter;
    const Messages messages(filter);
    filter->SetInputData(surface);
    if (curves)
    {
      filter->SetCurvesData(curves);
    }
    setUp(filter);
    filter->Update();
    this->Check.equal(std::string(filter->GetStatusName()), status, what + ": status");
    this->Check.that(filter->IsRefused(), what + ": is refused");
    this->Check.equal(messages.errors.size(), std::size_t{ 1 }, what + ": number of errors");
    this->Check.equal(messages.warnings.size(), std::size_t{ 0 }, what + ": number of warnings");
    if (!messages.errors.empty())
    {
      this->Check.contains(messages.errors[0], status, what + ": error");
      this->Check.contains(messages.errors[0], words, what + ": error");
    }
    Ids told;
    for (vtkIdType k = 0; k < filter->GetStatusIds()->GetNumberOfValues(); ++k)
    {
      told.insert(filter->GetStatusIds()->GetValue(k));
    }
    this->Check.that(told == ids, what + ": ids, message " + filter->GetStatusMessage());
    for (const int port : { 0, 1, 2 })
    {
      this->Check.that(isEmpty(filter->GetOutput(port)), what + ": output is empty");
    }
    this->Check.equal(text(filter->GetOutput(), "RunStatus"), status, what + ": RunStatus");
    vtkTable* const pieces = filter->GetPieces();
    this->Check.equal(pieces->GetNumberOfRows(), vtkIdType{ 1 }, what + ": rows of pieces");
    this->Check.equal(number(pieces, "Piece"), -1.0, what + ": its piece");
    this->Check.equal(text(pieces, "Status"), status, what + ": its status");
    this->Check.equal(
      text(pieces, "StatusMessage"), std::string(filter->GetStatusMessage()), what + ": message");
    this->Check.equal(
      pieces->GetNumberOfColumns(), vtkIdType{ 4 }, what + ": Piece Status Name StatusMessage");
    for (vtkTable* const table : { filter->GetCurves(), filter->GetAngleIterations() })
    {
      this->Check.equal(table->GetNumberOfRows(), vtkIdType{ 0 }, what + ": rows of a table");
    }
  }

private:
  Checks& Check;
};

vtkSmartPointer<vtkPolyData> makeSquare()
{
  return makePolyData(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
}

void surfacesAreRefused(Refusals& refusals)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkPolyData> empty;
  refusals.expect("an empty surface", empty, nullptr, "EmptySurface", {}, "triangulated");
  const auto line = makePolyData({ { 0, 0, 0 }, { 1, 0, 0 } }, {});
  addLine(line, { 0, 1 });
  refusals.expect("only lines", line, nullptr, "EmptySurface", {}, "no triangles");

  auto surface = makeSquare();
  surface->GetPoints()->SetPoint(2, nan, 1, 0);
  refusals.expect("a NaN", surface, nullptr, "NonFinitePoint", { 2 }, "points 2");
  surface =
    makePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, nan, 0 }, { 0, 1, 0 } }, { { 0, 1, 2, 3 } });
  refusals.expect("a NaN of a quad", surface, nullptr, "NonFinitePoint", { 2 }, "points 2");

  surface = makePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } }, { { 0, 1, 2, 7 } });
  refusals.expect(
    "a point id of a quad too large", surface, nullptr, "InvalidPointId", { 0 }, "0..2");

  surface = makePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 1 } });
  refusals.expect(
    "a polygon of two points", surface, nullptr, "DegenerateTriangle", { 1 }, "cells 1");

  refusals.expect(
    "a closed surface of quads", makeCube(), nullptr, "ClosedSurface", { 0 }, "cut it into pieces");
}

// Ids are those of the input's cells also where lines and larger polygons come before.
void idsAreThoseOfTheInput(Refusals& refusals)
{
  const auto surface = makePolyData(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 } },
    { { 0, 1, 2, 3 }, { 1, 4, 2 }, { 4, 5, 6 } });
  addLine(surface, { 0, 1 });
  addLine(surface, { 1, 2 });
  // Triangle 3 of the triangulation; cell 4 behind two lines, a quad and a triangle.
  refusals.expect("a triangle behind lines and a quad", surface, nullptr, "DegenerateTriangle",
    { 4 }, "in the input: cells 4", [](vtkWireWarpingFilter* filter) { filter->HealSurfaceOff(); });
}

void curvesAreRefused(Refusals& refusals)
{
  const auto grid = makeGrid(4, 4);
  auto curves = makePolyData({ { 0, 0.5, 0 }, { 0.5, 0.5, 0.7 }, { 1, 0.5, 0 } }, {});
  addLine(curves, { 0, 1, 2 });
  refusals.expect("a point off the surface", grid, curves, "CurvePointOffSurface", { 1 },
    "curve \"curve 0\": points 1");

  // From corner to corner against the diagonals.
  curves = makeCurves(grid, { { 4, 20 } });
  refusals.expect("a curve across triangles", grid, curves, "CurveNotOnEdges", { 4, 20 },
    "draw the curve along edges",
    [](vtkWireWarpingFilter* filter) { filter->SplitTrianglesOff(); });

  curves = makeCurves(grid, { { 10, 11, 12 }, { 7 } });
  refusals.expect("a curve of one point", grid, curves, "CurveTooShort", { 1 }, "fewer than two");
  curves = makeCurves(grid, { { 10, 11, 12 }, { 7, 7 } });
  refusals.expect(
    "a curve of one point twice", grid, curves, "CurveTooShort", { 1 }, "fewer than two");

  curves = makeCurves(grid, { { 10, 11, 12 }, { 2, 7, 12 } }, { 1, 4 });
  refusals.expect("an unknown type", grid, curves, "InvalidCurve", { 1 }, "CurveType \"4\"");
  curves = makeCurves(grid, { { 10, 11, 12 }, { 2, 7, 12 } });
  const auto names = filled<vtkStringArray>("CurveType", 1, 2, "zipper");
  names->SetValue(0, "key");
  curves->GetCellData()->AddArray(names);
  refusals.expect("an unknown type's name", grid, curves, "InvalidCurve", { 1 }, "\"zipper\"");

  const auto straight = [&grid] { return makeCurves(grid, { { 10, 11, 12 } }, { 1 }); };
  curves = straight();
  curves->GetCellData()->AddArray(filled<vtkIntArray>("KeyShape", 1, 1, 5));
  refusals.expect("an unknown key shape", grid, curves, "InvalidCurve", { 0 }, "KeyShape");
  curves = straight();
  curves->GetCellData()->AddArray(filled<vtkDoubleArray>("LengthTolerance", 1, 1, -0.1));
  refusals.expect("a negative tolerance", grid, curves, "InvalidCurve", { 0 }, "LengthTolerance");
  curves = straight();
  const auto planar = filled<vtkDoubleArray>("PlanarShape", 2, 25, 0.0);
  planar->SetComponent(11, 1, std::numeric_limits<double>::quiet_NaN());
  curves->GetPointData()->AddArray(planar);
  refusals.expect("a planar shape with a gap", grid, curves, "InvalidCurve", { 11 }, "PlanarShape");
  curves = straight();
  curves->GetPointData()->AddArray(filled<vtkStringArray>("PlanarShape", 2, 25, ""));
  refusals.expect("a planar shape of words", grid, curves, "InvalidCurve", {}, "no numbers");

  curves = makeCurves(grid, { { 10, 11, 99 } });
  refusals.expect("a curve with a wrong point id", grid, curves, "InvalidPointId", { 0 }, "0..24");
  curves = makePolyData({ { 0, 0.5, 0 }, { 0.25, std::nan(""), 0 }, { 1, 0.5, 0 } }, {});
  addLine(curves, { 0, 1, 2 });
  refusals.expect("a curve with a NaN", grid, curves, "NonFinitePoint", { 1 }, "points 1");
}
}

int TestWireWarpingFilterRefusals(int, char*[])
{
  Checks check;
  Refusals refusals(check);
  surfacesAreRefused(refusals);
  idsAreThoseOfTheInput(refusals);
  curvesAreRefused(refusals);
  return check.result();
}
