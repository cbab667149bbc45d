// SPDX-License-Identifier: BSD-3-Clause
#include "BlockLayout.h"

#include "Flattening/PieceArrangement.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace flattening
{
namespace bridge
{
namespace
{
/// A data set, and its number among the blocks.
struct Leaf
{
  vtkPolyData* data;
  double number;
};

std::vector<Leaf> leavesOf(vtkDataObject* object)
{
  std::vector<Leaf> leaves;
  const auto add = [&leaves](vtkDataObject* candidate, double number) {
    auto* const data = vtkPolyData::SafeDownCast(candidate);
    if (data && data->GetNumberOfPoints() > 0)
    {
      leaves.push_back({ data, number });
    }
  };
  add(object, 0.0);
  if (auto* const group = vtkCompositeDataSet::SafeDownCast(object))
  {
    const auto block = vtk::TakeSmartPointer(group->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      add(block->GetCurrentDataObject(), block->GetCurrentFlatIndex());
    }
  }
  return leaves;
}

/// Number of the block, process, width, height.
using BlockRow = std::array<double, 4>;

/// The rows of all processes in the order of the blocks.
std::vector<BlockRow> gatherRows(std::vector<BlockRow> rows, vtkMultiProcessController* processes)
{
  if (processes)
  {
    const vtkIdType length = static_cast<vtkIdType>(rows.size()) * std::tuple_size<BlockRow>::value;
    const auto count = static_cast<std::size_t>(processes->GetNumberOfProcesses());
    std::vector<vtkIdType> lengths(count);
    processes->AllGather(&length, lengths.data(), 1);
    std::vector<vtkIdType> offsets(count, 0);
    std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
    const auto all = static_cast<std::size_t>(offsets.back() + lengths.back());
    std::vector<BlockRow> gathered(all / std::tuple_size<BlockRow>::value);
    processes->AllGatherV(rows.empty() ? nullptr : rows.front().data(),
      gathered.empty() ? nullptr : gathered.front().data(), length, lengths.data(), offsets.data());
    rows = std::move(gathered);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

vtkBoundingBox boundsOf(const std::vector<Leaf>& leaves, vtkMultiProcessController* processes)
{
  vtkBoundingBox box;
  for (const Leaf& leaf : leaves)
  {
    box.AddBounds(leaf.data->GetBounds());
  }
  if (processes)
  {
    double low[3];
    double high[3];
    box.GetMinPoint(low[0], low[1], low[2]);
    box.GetMaxPoint(high[0], high[1], high[2]);
    double lowest[3];
    double highest[3];
    processes->AllReduce(low, lowest, 3, vtkCommunicator::MIN_OP);
    processes->AllReduce(high, highest, 3, vtkCommunicator::MAX_OP);
    box.SetMinPoint(lowest);
    box.SetMaxPoint(highest);
  }
  return box;
}

void move(vtkPolyData* flat, const Point2& shift)
{
  vtkPoints* const points = flat->GetPoints();
  for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
  {
    double point[3];
    points->GetPoint(p, point);
    points->SetPoint(p, point[0] + shift.x(), point[1] + shift.y(), point[2]);
  }
  points->Modified();
  flat->ComputeBounds();
}
}

void layBeside(vtkDataObject* surfaces, vtkDataObject* flat, double spacing,
  vtkMultiProcessController* processes)
{
  const vtkBoundingBox space = boundsOf(leavesOf(surfaces), processes);
  const double process = processes ? processes->GetLocalProcessId() : 0;
  const std::vector<Leaf> leaves = leavesOf(flat);
  std::vector<BlockRow> rows;
  for (const Leaf& leaf : leaves)
  {
    const vtkBoundingBox box(leaf.data->GetBounds());
    rows.push_back({ leaf.number, process, box.GetLength(0), box.GetLength(1) });
  }
  rows = gatherRows(std::move(rows), processes);
  if (rows.empty() || !space.IsValid())
  {
    return;
  }

  std::vector<Point2> sizes;
  for (const BlockRow& row : rows)
  {
    sizes.emplace_back(row[2], row[3]);
  }
  const std::vector<Point2> corners = cornersInRows(sizes, spacing);
  double height = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    height = std::max(height, corners[k].y() + sizes[k].y());
    largest = std::max(largest, sizes[k].maxCoeff());
  }
  double middle[3];
  space.GetCenter(middle);
  const Point2 origin(
    space.GetMaxPoint()[0] + std::max(2.0 * spacing, 0.1) * largest, middle[1] - 0.5 * height);
  auto leaf = leaves.begin();
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    if (rows[k][1] == process)
    {
      const double* const bounds = leaf->data->GetBounds();
      move(leaf->data, origin + corners[k] - Point2(bounds[0], bounds[2]));
      ++leaf;
    }
  }
}
}
}
