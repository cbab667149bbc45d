// SPDX-License-Identifier: BSD-3-Clause
// The filter as a part of a pipeline: composite input, with a table of pieces per block, and
// progress.
#include "FlatteningTesting.h"

#include "vtkMultiBlockDataSet.h"
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

void progressRises(Checks& check, vtkPolyData* piece)
{
  struct Log
  {
    vtkAlgorithm* algorithm;
    std::vector<double> fractions;
    void listen() { this->fractions.push_back(this->algorithm->GetProgress()); }
  };
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetInputData(piece);
  Log log{ filter, {} };
  filter->AddObserver(vtkCommand::ProgressEvent, &log, &Log::listen);
  filter->Update();
  check.that(std::is_sorted(log.fractions.begin(), log.fractions.end()), "progress never falls");
  check.that(
    log.fractions.size() > 3 && log.fractions.front() >= 0.0 && log.fractions.back() == 1.0,
    "progress ends at 1");
}
}

int TestWireWarpingFilterPipeline(int, char*[])
{
  Checks check;
  compositeInputFlattensBlockByBlock(check);
  progressRises(check, makePieceWithCurves());
  return check.result();
}
