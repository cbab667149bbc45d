// SPDX-License-Identifier: BSD-3-Clause
// Filters as parts of a pipeline: blocks are surfaces of their own, each with a table of
// pieces; partitions are parts of one surface, and none is flattened for itself.
#include "FlatteningTesting.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFeatureCurveCutter.h"
#include "vtkLeastSquaresConformalFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSurfaceDevelopability.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
vtkSmartPointer<vtkPolyData> makePieceWithCurves()
{
  const auto surface = makeQuarterSphere();
  addLine(surface,
    { lunePoint(0, 4), lunePoint(1, 4), lunePoint(2, 4), lunePoint(3, 4), lunePoint(4, 4) });
  return surface;
}

// Line cells of the surface's own data set are its curves, so a block is a piece with its curves.
void compositeInputFlattensBlockByBlock(Checks& check)
{
  const auto alone = updated<vtkWireWarpingFilter>(makePieceWithCurves());
  check.equal(number(alone, "WirePatches"), 2.0, "wire-patches of the piece alone");

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePieceWithCurves());
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, makeGrid(3, 2));
  inner->SetBlock(1, makePieceWithCurves());
  blocks->SetBlock(1, inner);
  vtkNew<vtkPolyData> empty;
  blocks->SetBlock(2, empty);
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(blocks);
  filter->Update();
  check.equal(messages.errors.size(), std::size_t{ 1 }, "one error, of the empty block");
  for (const int port : { 0, 1, 2 })
  {
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    check.that(output != nullptr, "composite output of port " + std::to_string(port));
    if (!output)
    {
      continue;
    }
    auto* innerOutput = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(1));
    check.that(innerOutput != nullptr, "nested blocks stay nested");
    vtkPolyData* expected = alone->GetOutput(port);
    for (vtkDataObject* block : { output->GetBlock(0), innerOutput->GetBlock(1) })
    {
      auto* data = vtkPolyData::SafeDownCast(block);
      check.that(data != nullptr, "a block is polydata");
      samePoints(check, data, expected, "block of port " + std::to_string(port));
      check.equal(data->GetNumberOfCells(), expected->GetNumberOfCells(), "cells of a block");
    }
    auto* grid = vtkPolyData::SafeDownCast(innerOutput->GetBlock(0));
    check.that(grid && grid->GetNumberOfPoints() == 12, "the block without curves is flattened");
    auto* refused = vtkPolyData::SafeDownCast(output->GetBlock(2));
    check.that(refused && isEmpty(refused), "the refused block is empty");
    if (port == 0 && refused)
    {
      check.equal(text(refused, "RunStatus"), "EmptySurface", "status of the refused block");
      check.equal(text(vtkPolyData::SafeDownCast(output->GetBlock(0)), "RunStatus"), "Ok",
        "status of a good block");
    }
  }
  auto* const tables = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(3));
  check.that(tables && tables->GetNumberOfBlocks() == 3, "tables of three blocks");
  for (const unsigned int k : { 0U, 2U })
  {
    auto* const table = vtkTable::SafeDownCast(tables ? tables->GetBlock(k) : nullptr);
    check.that(table && table->GetNumberOfRows() == 1, "rows of a block");
    check.equal(table ? text(table, "Status") : "", k == 2 ? "EmptySurface" : "Ok", "its status");
  }
}

vtkSmartPointer<vtkPolyData> half(double sign)
{
  return makeGrid(3, 4, [sign](double x, double y) { return sign * 0.2 * x * y; });
}

/// Triangles of each leaf of the output.
std::vector<vtkIdType> cellsOf(vtkDataObject* output)
{
  std::vector<vtkIdType> cells;
  auto* const tree = vtkDataObjectTree::SafeDownCast(output);
  const auto leaf = vtk::TakeSmartPointer(tree->NewTreeIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    auto* const data = vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject());
    cells.push_back(data ? data->GetNumberOfCells() : 0);
  }
  return cells;
}

template <class Filter, class Parts>
void refusesParts(Checks& checks, const std::string& name)
{
  vtkNew<Parts> parts;
  parts->SetNumberOfPartitions(3);
  parts->SetPartition(0, half(1.0));
  parts->SetPartition(2, half(-1.0));
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, half(1.0));
  collection->SetPartition(1, 0, half(1.0));
  collection->SetPartition(1, 1, half(-1.0));
  for (vtkDataObject* const input :
    std::initializer_list<vtkDataObject*>{ parts.GetPointer(), collection.GetPointer() })
  {
    vtkNew<Filter> filter;
    const Messages messages(filter);
    filter->SetInputDataObject(input);
    filter->Update();
    checks.equal(filter->GetStatusName(), std::string("InvalidOption"), name + ": status");
    checks.equal(messages.errors.size(), 1U, name + ": errors");
    if (!messages.errors.empty())
    {
      checks.contains(messages.errors[0], "comes in 2 partitions", name + ": the defect");
      checks.contains(messages.errors[0], "Merge Blocks", name + ": a remedy");
    }
    const std::vector<vtkIdType> cells = cellsOf(filter->GetOutputDataObject(0));
    const std::vector<vtkIdType> expected =
      input == parts ? std::vector<vtkIdType>{ 0, 0 } : std::vector<vtkIdType>{ 24, 0, 0 };
    checks.that(cells == expected, name + ": cells of the output");
  }
}

void takesWhatIsWhole(Checks& checks)
{
  const auto flattens = [&checks](
                          vtkDataObject* input, std::size_t surfaces, const std::string& what) {
    vtkNew<vtkWireWarpingFilter> filter;
    const Messages messages(filter);
    filter->SetInputDataObject(input);
    filter->Update();
    checks.equal(filter->GetStatusName(), std::string("Ok"), what + ": status");
    checks.that(messages.errors.empty(), what + ": no error");
    const std::vector<vtkIdType> cells = cellsOf(filter->GetOutputDataObject(0));
    checks.equal(
      static_cast<std::size_t>(std::count(cells.begin(), cells.end(), 24)), surfaces, what);
  };

  vtkNew<vtkPartitionedDataSet> one;
  one->SetNumberOfPartitions(3);
  one->SetPartition(0, vtkNew<vtkPolyData>());
  one->SetPartition(2, half(1.0));
  flattens(one, 1, "one partition with cells among three");

  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, half(1.0));
  collection->SetPartition(1, 1, half(-1.0));
  flattens(collection, 2, "a collection of two surfaces");

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, half(1.0));
  vtkNew<vtkMultiPieceDataSet> pieces;
  pieces->SetPiece(1, half(1.0));
  blocks->SetBlock(1, pieces);
  blocks->SetBlock(3, half(-1.0));
  flattens(blocks, 3, "blocks, one of them in one piece");
}
}

int TestWireWarpingFilterPipeline(int, char*[])
{
  Checks check;
  compositeInputFlattensBlockByBlock(check);
  refusesParts<vtkWireWarpingFilter, vtkPartitionedDataSet>(check, "vtkWireWarpingFilter");
  refusesParts<vtkWireWarpingFilter, vtkMultiPieceDataSet>(check, "pieces");
  refusesParts<vtkLeastSquaresConformalFilter, vtkPartitionedDataSet>(
    check, "vtkLeastSquaresConformalFilter");
  refusesParts<vtkFeatureCurveCutter, vtkPartitionedDataSet>(check, "vtkFeatureCurveCutter");
  takesWhatIsWhole(check);

  // What looks at each place for itself takes parts.
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, half(1.0));
  parts->SetPartition(1, half(-1.0));
  vtkNew<vtkSurfaceDevelopability> developability;
  developability->SetInputDataObject(parts);
  developability->Update();
  check.equal(developability->GetStatusName(), std::string("Ok"), "developability");
  return check.result();
}
