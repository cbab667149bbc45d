// SPDX-License-Identifier: BSD-3-Clause
// Partitions are parts of one surface: none is flattened for itself. Blocks are surfaces of their
// own.
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
      checks.contains(messages.errors[0], "Merge Blocks", name + ": a way out");
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

int TestPartitions(int, char*[])
{
  Checks checks;
  refusesParts<vtkWireWarpingFilter, vtkPartitionedDataSet>(checks, "vtkWireWarpingFilter");
  refusesParts<vtkWireWarpingFilter, vtkMultiPieceDataSet>(checks, "pieces");
  refusesParts<vtkLeastSquaresConformalFilter, vtkPartitionedDataSet>(
    checks, "vtkLeastSquaresConformalFilter");
  refusesParts<vtkFeatureCurveCutter, vtkPartitionedDataSet>(checks, "vtkFeatureCurveCutter");
  takesWhatIsWhole(checks);

  // What looks at each place for itself takes parts.
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, half(1.0));
  parts->SetPartition(1, half(-1.0));
  vtkNew<vtkSurfaceDevelopability> developability;
  developability->SetInputDataObject(parts);
  developability->Update();
  checks.equal(developability->GetStatusName(), std::string("Ok"), "developability");
  return checks.result();
}
