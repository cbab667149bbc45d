// SPDX-License-Identifier: BSD-3-Clause
#include "Distribution.h"

#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPolyData.h"

#include <limits>
#include <utility>

namespace flattening::bridge
{
namespace
{
/// A block a connection, and in it a block a data set.
vtkSmartPointer<vtkMultiBlockDataSet> pack(const ConnectedCurves& curves)
{
  auto packed = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t k = 0; k < curves.data.size(); ++k)
  {
    const auto connection = static_cast<unsigned int>(curves.connections[k]);
    auto* block = connection < packed->GetNumberOfBlocks()
      ? vtkMultiBlockDataSet::SafeDownCast(packed->GetBlock(connection))
      : nullptr;
    if (!block)
    {
      vtkNew<vtkMultiBlockDataSet> made;
      packed->SetBlock(connection, made);
      block = made;
    }
    const unsigned int place = block->GetNumberOfBlocks();
    block->SetBlock(place, curves.data[k]);
    block->GetMetaData(place)->Set(vtkCompositeDataSet::NAME(), curves.blocks[k]);
  }
  return packed;
}

/// A data set and the number of the surface that it is, or is a part of.
struct NumberedLeaf
{
  vtkDataObject* data;
  std::size_t surface;
};

/// The leaves that are there, and how many surfaces there may be. A data set alone has the number
/// 0.
std::pair<std::vector<NumberedLeaf>, std::size_t> numberedLeaves(vtkDataObject* object)
{
  std::vector<NumberedLeaf> leaves;
  auto* const tree = vtkDataObjectTree::SafeDownCast(object);
  if (!tree)
  {
    if (object)
    {
      leaves.push_back({ object, 0 });
    }
    return { leaves, leaves.size() };
  }
  // Processes may have different numbers of partitions, so these must not count.
  const auto node = vtk::TakeSmartPointer(tree->NewTreeIterator());
  node->VisitOnlyLeavesOff();
  node->SkipEmptyNodesOff();
  std::size_t surfaces = 1;
  unsigned int endOfPartitions = 0;
  const auto enter = [&endOfPartitions](vtkDataObject* parent, unsigned int number) {
    if (auto* const partitions = vtkPartitionedDataSet::SafeDownCast(parent))
    {
      endOfPartitions = number + partitions->GetNumberOfPartitions();
    }
  };
  enter(tree, 0);
  for (node->InitTraversal(); !node->IsDoneWithTraversal(); node->GoToNextItem())
  {
    const unsigned int number = node->GetCurrentFlatIndex();
    if (number > endOfPartitions)
    {
      ++surfaces;
    }
    vtkDataObject* const data = node->GetCurrentDataObject();
    enter(data, number);
    if (data && !vtkCompositeDataSet::SafeDownCast(data))
    {
      leaves.push_back({ data, surfaces - 1 });
    }
  }
  return { leaves, surfaces };
}

void unpack(vtkDataObject* object, ConnectedCurves& curves)
{
  auto* const packed = vtkMultiBlockDataSet::SafeDownCast(object);
  for (unsigned int c = 0; packed && c < packed->GetNumberOfBlocks(); ++c)
  {
    auto* const block = vtkMultiBlockDataSet::SafeDownCast(packed->GetBlock(c));
    for (unsigned int k = 0; block && k < block->GetNumberOfBlocks(); ++k)
    {
      if (auto* const data = vtkPolyData::SafeDownCast(block->GetBlock(k)))
      {
        curves.data.emplace_back(data);
        curves.connections.push_back(static_cast<int>(c));
        const char* const name =
          block->HasMetaData(k) ? block->GetMetaData(k)->Get(vtkCompositeDataSet::NAME()) : nullptr;
        curves.blocks.emplace_back(name ? name : "");
      }
    }
  }
}
}

vtkMultiProcessController* processesOf(bool distributed)
{
  vtkMultiProcessController* const all =
    distributed ? vtkMultiProcessController::GetGlobalController() : nullptr;
  return all && all->GetNumberOfProcesses() > 1 ? all : nullptr;
}

std::map<const vtkDataObject*, SurfaceOwners> ownersOf(
  vtkDataObject* surface, vtkMultiProcessController* processes)
{
  const auto [leaves, mine] = numberedLeaves(surface);
  // A block that another process has may not be there at all here.
  const auto last = static_cast<vtkIdType>(mine);
  vtkIdType count = last;
  if (processes)
  {
    processes->AllReduce(&last, &count, 1, vtkCommunicator::MAX_OP);
  }
  const int process = processes ? processes->GetLocalProcessId() : 0;
  const auto hasCells = [](const NumberedLeaf& leaf) {
    auto* const data = vtkPolyData::SafeDownCast(leaf.data);
    return data && data->GetNumberOfCells() > 0;
  };
  // Of each surface: parts here, whether there is one, and the first process that has a data set of
  // it.
  std::vector<int> parts(static_cast<std::size_t>(count), 0);
  std::vector<int> any = parts;
  std::vector<int> speaker(parts.size(), std::numeric_limits<int>::max());
  for (const NumberedLeaf& leaf : leaves)
  {
    parts[leaf.surface] += hasCells(leaf) ? 1 : 0;
    any[leaf.surface] = parts[leaf.surface] > 0 ? 1 : 0;
    speaker[leaf.surface] = process;
  }
  if (processes && count > 0)
  {
    const auto reduce = [processes, count](std::vector<int>& values, int operation) {
      const std::vector<int> here = values;
      processes->AllReduce(here.data(), values.data(), count, operation);
    };
    reduce(parts, vtkCommunicator::SUM_OP);
    reduce(any, vtkCommunicator::SUM_OP);
    reduce(speaker, vtkCommunicator::MIN_OP);
  }
  std::map<const vtkDataObject*, SurfaceOwners> owners;
  std::vector<bool> spoken(parts.size(), false);
  for (const NumberedLeaf& leaf : leaves)
  {
    SurfaceOwners& found = owners[leaf.data];
    found.first = speaker[leaf.surface] == process && !spoken[leaf.surface];
    spoken[leaf.surface] = true;
    found.parts = parts[leaf.surface];
    found.processes = any[leaf.surface];
    found.here = hasCells(leaf) || (found.parts == 0 && found.first);
  }
  return owners;
}

ConnectedCurves gatherCurves(const ConnectedCurves& here, vtkMultiProcessController* processes)
{
  if (!processes)
  {
    return here;
  }
  vtkNew<vtkCharArray> sent;
  vtkCommunicator::MarshalDataObject(pack(here), sent);
  const vtkIdType length = sent->GetNumberOfValues();
  const auto count = static_cast<std::size_t>(processes->GetNumberOfProcesses());
  std::vector<vtkIdType> lengths(count);
  processes->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(count, 0);
  for (std::size_t p = 1; p < count; ++p)
  {
    offsets[p] = offsets[p - 1] + lengths[p - 1];
  }
  vtkNew<vtkCharArray> received;
  received->SetNumberOfValues(offsets.back() + lengths.back());
  processes->AllGatherV(
    sent->GetPointer(0), received->GetPointer(0), length, lengths.data(), offsets.data());

  ConnectedCurves all;
  for (std::size_t p = 0; p < count; ++p)
  {
    vtkNew<vtkCharArray> part;
    part->SetArray(received->GetPointer(offsets[p]), lengths[p], 1);
    const auto object = vtkCommunicator::UnMarshalDataObject(part);
    unpack(object, all);
  }
  return all;
}
}
