// SPDX-License-Identifier: BSD-3-Clause
// Where the flat points are and how precise: single precision as VTK's filters have it, beside the
// surface, and blocks beside each other. Lists without rows are no arrays.
#include "FlatteningTesting.h"

#include "vtkBoundingBox.h"
#include "vtkFeatureCurveCutter.h"
#include "vtkFloatArray.h"
#include "vtkLeastSquaresConformalFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
void singlePrecisionRoundsThePointsAlone(Checks& check)
{
  const auto surface = makeQuarterSphere();
  const auto exact = updated<vtkWireWarpingFilter>(surface, makeQuarterSphereArc(surface));
  vtkNew<vtkWireWarpingFilter> rounded;
  rounded->SetInputData(surface);
  rounded->SetCurvesData(makeQuarterSphereArc(surface));
  rounded->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  rounded->Update();
  check.equal(exact->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE, "precision by default");
  for (const int port : { 0, 1, 2 })
  {
    const std::string what = "output " + std::to_string(port);
    vtkPolyData* const before = exact->GetOutput(port);
    vtkPolyData* const after = rounded->GetOutput(port);
    check.equal(after->GetPoints()->GetDataType(), VTK_FLOAT, "type of the points of " + what);
    for (vtkIdType p = 0; p < before->GetNumberOfPoints(); ++p)
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto nearest = static_cast<float>(before->GetPoint(p)[k]);
        check.equal(after->GetPoint(p)[k], static_cast<double>(nearest), "a coordinate of " + what);
      }
    }
    sameArrays(check, after->GetPointData(), before->GetPointData(), "points of " + what);
    sameArrays(check, after->GetCellData(), before->GetCellData(), "cells of " + what);
    sameArrays(check, after->GetFieldData(), before->GetFieldData(), what);
  }
  check.that(rounded->GetOutput(0)->GetPoints() == rounded->GetOutput(1)->GetPoints(),
    "pieces and wires share rounded points");
  // The promise of the arrays is that of the points before they were rounded.
  check.that(number(rounded, "MaxEdgeLengthError") < 1e-12, "the reported error");
  const double error = largestLengthError(
    rounded->GetOutput(1), rounded->GetOutput(0)->GetPoints(), exact->GetOutput(2)->GetPoints());
  check.that(error > 1e-12 && error < 1e-5, "lengths between rounded points");

  rounded->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  rounded->Update();
  check.equal(rounded->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE, "double on request");
}

vtkBoundingBox boxOf(vtkDataObject* object)
{
  auto* const data = vtkPolyData::SafeDownCast(object);
  return data ? vtkBoundingBox(data->GetBounds()) : vtkBoundingBox();
}

/// Whether two boxes share more than a border in x and y.
bool overlap(const vtkBoundingBox& a, const vtkBoundingBox& b)
{
  const auto along = [&](int k) {
    return a.GetMinPoint()[k] < b.GetMaxPoint()[k] && b.GetMinPoint()[k] < a.GetMaxPoint()[k];
  };
  return along(0) && along(1);
}

template <class Filter>
void blocksLieBesideTheSurfaces(Checks& check)
{
  // Two blocks in the same place, one empty, and one inside another block.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeQuarterSphere());
  blocks->SetBlock(1, makeQuarterSphere());
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, makeGrid(5, 4));
  blocks->SetBlock(3, inner);
  vtkNew<Filter> filter;
  filter->SetInputData(blocks);
  filter->Update();
  auto* const origin = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  check.that(overlap(boxOf(origin->GetBlock(0)), boxOf(origin->GetBlock(1))),
    "at first blocks start from the origin");
  vtkNew<vtkPolyData> alone;
  alone->DeepCopy(origin->GetBlock(1));

  filter->BesideSurfaceOn();
  filter->Update();
  auto* const flat = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* const wires = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  auto* const cut = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(2));
  auto* const innerFlat = vtkMultiBlockDataSet::SafeDownCast(flat->GetBlock(3));
  auto* const innerWires = vtkMultiBlockDataSet::SafeDownCast(wires->GetBlock(3));
  const std::array<vtkBoundingBox, 3> boxes{ boxOf(flat->GetBlock(0)), boxOf(flat->GetBlock(1)),
    boxOf(innerFlat->GetBlock(0)) };
  const std::array<vtkBoundingBox, 3> wireBoxes{ boxOf(wires->GetBlock(0)),
    boxOf(wires->GetBlock(1)), boxOf(innerWires->GetBlock(0)) };
  for (std::size_t a = 0; a < boxes.size(); ++a)
  {
    check.that(boxes[a].IsValid(), "a block is flattened");
    check.that(boxes[a].GetMinPoint()[0] > 1.0, "right of the surfaces, which end at x = 1");
    check.that(boxes[a].GetMinPoint()[2] == 0.0 && boxes[a].GetMaxPoint()[2] == 0.0, "z is 0");
    check.that(boxes[a] == wireBoxes[a], "wires go with their piece");
    for (std::size_t b = 0; b < a; ++b)
    {
      check.that(!overlap(boxes[a], boxes[b]), "blocks lie beside each other");
    }
  }
  // The cut surface stays in space, and the shape is that of the piece at the origin.
  check.that(boxOf(cut->GetBlock(1)) == boxOf(makeQuarterSphere()), "the surface stays");
  auto* const moved = vtkPolyData::SafeDownCast(flat->GetBlock(1));
  check.equal(moved->GetNumberOfPoints(), alone->GetNumberOfPoints(), "points of a moved block");
  for (vtkIdType p = 1; p < moved->GetNumberOfPoints(); ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double step = alone->GetPoint(p)[k] - alone->GetPoint(0)[k];
      check.near(moved->GetPoint(p)[k] - moved->GetPoint(0)[k], step, 1e-14, "a moved point");
    }
  }

  // One surface: beside it as well, on its height, and where it was when asked for no more.
  vtkNew<Filter> one;
  one->SetInputData(makeQuarterSphere());
  one->BesideSurfaceOn();
  one->Update();
  check.that(one->GetOutput()->GetBounds()[0] > 1.0, "one piece right of its surface");
  const double* const bounds = one->GetOutput()->GetBounds();
  check.near(0.5 * (bounds[2] + bounds[3]), 0.5, 1e-12, "at half the height of its surface");
  one->BesideSurfaceOff();
  one->Update();
  check.near(one->GetOutput()->GetBounds()[0], 0.0, 1e-14, "at the origin again");
}

void listsWithoutRowsAreNoArrays(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> filter;
  const auto surface = makeGrid(4, 3);
  // Lists that the input has from an earlier run do not pass for those of this one.
  for (const char* name : { "SeamPairs", "GrainAngle" })
  {
    surface->GetFieldData()->AddArray(filled<vtkIdTypeArray>(name, 1, 1, 7));
  }
  surface->GetFieldData()->AddArray(filled<vtkIdTypeArray>("OwnList", 1, 0, 0));
  filter->SetInputData(surface);
  vtkNew<vtkFeatureCurveCutter> cutter;
  cutter->SetInputData(surface);
  for (vtkAlgorithm* algorithm :
    { static_cast<vtkAlgorithm*>(filter), static_cast<vtkAlgorithm*>(cutter) })
  {
    algorithm->Update();
    auto* const output = vtkPolyData::SafeDownCast(algorithm->GetOutputDataObject(0));
    vtkFieldData* const field = output->GetFieldData();
    check.that(!field->HasArray("SeamPairs"), "SeamPairs has no row here");
    for (int k = 0; k < field->GetNumberOfArrays(); ++k)
    {
      const std::string name = field->GetArrayName(k);
      check.that(name == "OwnList" || field->GetAbstractArray(k)->GetNumberOfTuples() > 0,
        name + " is not empty");
    }
    check.that(field->HasArray("OwnList") != 0, "what the input has passes");
  }
  check.that(!filter->GetOutput()->GetFieldData()->HasArray("GrainAngle"), "there is no material");
  check.equal(filter->GetLeftOutPieces()->GetNumberOfRows(), vtkIdType{ 0 }, "nothing is left out");
}
}

int TestOutputPoints(int, char*[])
{
  Checks check;
  singlePrecisionRoundsThePointsAlone(check);
  blocksLieBesideTheSurfaces<vtkWireWarpingFilter>(check);
  blocksLieBesideTheSurfaces<vtkLeastSquaresConformalFilter>(check);
  listsWithoutRowsAreNoArrays(check);
  return check.result();
}
