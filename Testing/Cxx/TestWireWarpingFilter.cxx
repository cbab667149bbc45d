// SPDX-License-Identifier: BSD-3-Clause
// The paper's quarter-sphere through the filter: Table 1's numbers, the documented arrays, carried
// data.
#include "FlatteningTesting.h"

#include "vtkWireWarpingFilter.h"

#include <set>

using namespace flatteningTesting;

namespace
{
vtkSmartPointer<vtkWireWarpingFilter> makeFilter()
{
  const auto surface = makeQuarterSphere();
  auto filter = vtkSmartPointer<vtkWireWarpingFilter>::New();
  filter->SetInputData(surface);
  filter->SetCurvesData(makeQuarterSphereArc(surface));
  filter->SetInteriorToLaplacian();
  return filter;
}

// Table 1: E_ang and E_h to the digits that the paper prints, E_len = 0.
void tableOneIsReproduced(Checks& check)
{
  struct Row
  {
    int scheme;
    double angleError;
    double homogeneity;
  };
  for (const Row& row : { Row{ vtkWireWarpingFilter::PROGRESSIVE, 0.159115, 0.39359 },
         Row{ vtkWireWarpingFilter::GLOBAL, 0.148796, 0.40397 } })
  {
    for (const int solver : { vtkWireWarpingFilter::NEWTON, vtkWireWarpingFilter::SEQUENTIAL })
    {
      const auto filter = makeFilter();
      filter->SetScheme(row.scheme);
      filter->SetSolver(solver);
      filter->Update();
      vtkPolyData* flat = filter->GetOutput();
      const std::string name =
        std::string(filter->GetSchemeAsString()) + ", " + filter->GetSolverAsString() + ": ";
      check.equal(std::string(filter->GetStatusName()), "Ok", name + "status");
      check.near(number(filter, "AngleErrorMean"), row.angleError, 5e-7, name + "E_ang");
      check.near(number(filter, "GlobalHomogeneity"), row.homogeneity, 5e-6, name + "E_h");
      check.near(number(filter, "MaxEdgeLengthError"), 0.0, 1e-13, name + "E_len_max");
      check.equal(number(filter, "FreeWireNodes"), 24.0, name + "FreeWireNodes");
      check.equal(number(filter, "Constraints"), 3.0 * 2 + 3, name + "Constraints");
      check.near(largestLengthError(
                   filter->GetOutput(1), flat->GetPoints(), filter->GetOutput(2)->GetPoints()),
        0.0, 1e-10, name + "length error measured on the outputs");
      if (row.scheme == vtkWireWarpingFilter::GLOBAL)
      {
        check.near(number(filter, "Objective"), 0.197157, 5e-7, name + "objective");
      }
    }
  }
}

void outputsAreAsDocumented(Checks& check)
{
  const auto filter = makeFilter();
  filter->Update();
  vtkPolyData* flat = filter->GetOutput(0);
  vtkPolyData* wires = filter->GetOutput(1);
  vtkPolyData* cut = filter->GetOutput(2);
  check.equal(flat->GetNumberOfPoints(), 37, "points of the flat piece");
  check.equal(flat->GetNumberOfPolys(), 56, "triangles of the flat piece");
  check.equal(flat->GetPoints()->GetDataType(), VTK_DOUBLE, "type of the points");
  check.equal(flat->GetBounds()[4], 0.0, "lowest z");
  check.equal(flat->GetBounds()[5], 0.0, "highest z");
  for (const char* name : { "HomogeneityOfDistortion", "AspectRatio", "AreaRatio", "AngleError",
         "Flipped", "PieceId", "WirePatchId", "vtkOriginalCellIds" })
  {
    check.that(flat->GetCellData()->HasArray(name), std::string("flat cells have ") + name);
    check.that(cut->GetCellData()->HasArray(name), std::string("cut cells have ") + name);
  }
  for (const char* name : { "Developability", "vtkOriginalPointIds" })
  {
    check.that(flat->GetPointData()->HasArray(name), std::string("flat points have ") + name);
    check.that(cut->GetPointData()->HasArray(name), std::string("cut points have ") + name);
  }
  std::set<std::string> fields;
  for (int k = 0; k < flat->GetFieldData()->GetNumberOfArrays(); ++k)
  {
    fields.insert(flat->GetFieldData()->GetArrayName(k));
  }
  check.that(fields == std::set<std::string>{ "RunStatus", "RunStatusMessage" },
    "field data has what other filters read alone");
  check.equal(wires->GetFieldData()->GetNumberOfArrays(), 0, "field data of the wires");
  check.equal(number(filter, "Triangles"), 56.0, "Triangles");
  check.equal(number(filter, "Vertices"), 37.0, "Vertices");
  check.equal(number(filter, "WirePatches"), 2.0, "WirePatches");
  check.equal(number(filter, "WireNodes"), 24.0, "WireNodes");
  check.equal(text(filter->GetPieces(), "Status"), "Ok", "Status");
  check.equal(text(flat, "RunStatus"), "Ok", "RunStatus");
  check.that(filter->GetAngleIterations()->GetNumberOfRows() > 0, "there are iterations");
  check.that(filter->GetSeconds()[3] > 0.0, "the time is measured");

  check.that(!flat->GetCellData()->HasArray("WarpingOrder"), "GLOBAL has no warping order");
  filter->SetSchemeToProgressive();
  filter->Update();
  double range[2] = { -1.0, -1.0 };
  check.that(flat->GetCellData()->HasArray("WarpingOrder"), "PROGRESSIVE has a warping order");
  flat->GetCellData()->GetArray("WarpingOrder")->GetRange(range);
  check.that(range[0] == 0.0 && range[1] == 1.0, "two wire-patches are warped one after the other");
}

void dataIsCarriedAndTheInputIsLeftAlone(Checks& check)
{
  const auto surface = makeQuarterSphere();
  surface->GetPointData()->SetScalars(arrayOf<vtkDoubleArray>(
    "PointValue", 37, [](vtkIdType p) { return 0.5 * static_cast<double>(p); }));
  surface->GetCellData()->AddArray(arrayOf<vtkStringArray>(
    "CellValue", 56, [](vtkIdType c) { return "cell " + std::to_string(c); }));
  surface->GetFieldData()->AddArray(filled<vtkIntArray>("Season", 1, 1, 2008));
  vtkNew<vtkPolyData> before;
  before->DeepCopy(surface);
  const vtkMTimeType time = surface->GetMTime();

  const auto filter = updated<vtkWireWarpingFilter>(surface, makeQuarterSphereArc(surface));

  check.equal(surface->GetMTime(), time, "modification time of the input");
  check.equal(surface->GetPointData()->GetNumberOfArrays(), 1, "point arrays of the input");
  check.equal(surface->GetCellData()->GetNumberOfArrays(), 1, "cell arrays of the input");
  samePoints(check, surface, before, "input");
  for (const int port : { 0, 2 })
  {
    vtkPolyData* output = filter->GetOutput(port);
    vtkDataArray* points = output->GetPointData()->GetArray("PointValue");
    auto* cells =
      vtkStringArray::SafeDownCast(output->GetCellData()->GetAbstractArray("CellValue"));
    auto* pointIds =
      vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetArray("vtkOriginalPointIds"));
    auto* cellIds =
      vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("vtkOriginalCellIds"));
    check.that(points && cells && pointIds && cellIds, "data and ids are carried");
    if (!points || !cells || !pointIds || !cellIds)
    {
      return;
    }
    check.that(output->GetPointData()->GetScalars() == points, "active scalars stay active");
    for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
    {
      check.equal(points->GetComponent(p, 0), 0.5 * static_cast<double>(pointIds->GetValue(p)),
        "point value");
    }
    for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
    {
      check.equal(cells->GetValue(c), "cell " + std::to_string(cellIds->GetValue(c)), "cell value");
      check.equal(cellIds->GetValue(c), c, "cells come in the input's order");
    }
  }
  // Round trip: the cut surface's points are those of the input that the ids tell.
  vtkPolyData* cut = filter->GetOutput(2);
  auto* ids = vtkIdTypeArray::SafeDownCast(cut->GetPointData()->GetArray("vtkOriginalPointIds"));
  for (vtkIdType p = 0; p < cut->GetNumberOfPoints(); ++p)
  {
    double original[3];
    surface->GetPoint(ids->GetValue(p), original);
    check.equal(
      vtkMath::Distance2BetweenPoints(cut->GetPoint(p), original), 0.0, "distance to its original");
  }
  check.equal(number(filter->GetOutput(), "Season"), 2008.0, "field data");
}

// A grid of quads, a strip and doubled points is the surface of its triangles.
void polygonsAreTriangulatedAndPointsJoined(Checks& check)
{
  const auto surface =
    makePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 2, 0, 0 },
                   { 2, 1, 0 }, { 1, 1, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 9, 9, 9 } },
      { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 5, 8, 6, 9 });
  surface->SetStrips(strips);
  const auto filter = updated<vtkWireWarpingFilter>(surface);
  check.equal(
    filter->GetPieces()->GetNumberOfRows(), 2, "pieces while the doubled points are kept apart");
  filter->SetCoincidentPointsToJoin();
  filter->Update();
  vtkPolyData* flat = filter->GetOutput();
  check.equal(std::string(filter->GetStatusName()), "Ok", "status of the strip of quads");
  check.equal(flat->GetNumberOfPolys(), 6, "triangles");
  check.equal(flat->GetNumberOfPoints(), 8, "joined points");
  check.equal(number(filter, "Triangles", 0), 6.0, "triangles of the one piece");
  auto* cellIds = vtkIdTypeArray::SafeDownCast(flat->GetCellData()->GetArray("vtkOriginalCellIds"));
  for (vtkIdType t = 0; cellIds && t < 6; ++t)
  {
    check.equal(cellIds->GetValue(t), t / 2, "cell of a triangle");
  }
  check.near(number(filter, "AreaError"), 0.0, 1e-12, "a flat surface stays as it is: E_area");
  check.near(number(filter, "AngleErrorMean"), 0.0, 1e-12, "a flat surface stays as it is: E_ang");
}
}

int TestWireWarpingFilter(int, char*[])
{
  Checks check;
  tableOneIsReproduced(check);
  outputsAreAsDocumented(check);
  dataIsCarriedAndTheInputIsLeftAlone(check);
  polygonsAreTriangulatedAndPointsJoined(check);
  return check.result();
}
