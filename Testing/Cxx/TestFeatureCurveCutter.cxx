// SPDX-License-Identifier: BSD-3-Clause
// Cuts whose result can be counted by hand: copies of points, pieces, seam pairs, wires.
#include "FlatteningTesting.h"

#include "vtkFeatureCurveCutter.h"

#include <map>

using namespace flatteningTesting;

namespace
{
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

int TestFeatureCurveCutter(int, char*[])
{
  Checks check;
  aDartOpens(check);
  return check.result();
}
