// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;
class vtkPolyData;

namespace flattening::bridge
{
/// The controller of several processes that run a filter together, each with a part of the data;
/// null where this one is alone.
vtkMultiProcessController* processesOf(bool distributed);

/// Where the cells of a surface are.
struct SurfaceOwners
{
  /// Data sets with cells of it, on all processes together, and processes that have such.
  int parts = 1;
  int processes = 1;
  /// Whether this data set is one of them.
  bool here = true;
  /// Whether this data set speaks for all of them.
  bool first = true;
};

/// A surface without cells belongs to the first data set that there is of it. Of a composite data
/// set the owners of each leaf: the partitions of a vtkPartitionedDataSet are parts of one surface,
/// on whichever process, any other leaf is a surface of its own, the same on all processes. All
/// must call it together.
std::map<const vtkDataObject*, SurfaceOwners> ownersOf(
  vtkDataObject* surface, vtkMultiProcessController* processes);

/// Curves, the connection that each came by, and the block of it in words; none where it is not
/// composite.
struct ConnectedCurves
{
  std::vector<vtkSmartPointer<vtkPolyData>> data;
  std::vector<int> connections;
  std::vector<std::string> blocks;
};

/// The curves of all processes, the same on each. All processes must call it together.
ConnectedCurves gatherCurves(const ConnectedCurves& here, vtkMultiProcessController* processes);
}
