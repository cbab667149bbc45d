// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataOutput.h"

#include "AttributeArrays.h"
#include "PolyDataSets.h"

namespace wirewarp
{
vtkSmartPointer<vtkPolyData> polyDataOf(const flattening::DataSet& data, vtkPoints* shared)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  flattening::bridge::fill(result, data);
  if (shared)
  {
    result->SetPoints(shared);
  }
  return result;
}

vtkSmartPointer<vtkTable> tableOf(const flattening::Columns& columns)
{
  return flattening::bridge::makeTable(columns);
}

flattening::DataSet dataSetOf(vtkPolyData* data)
{
  return flattening::bridge::dataSetOf(data);
}
}
