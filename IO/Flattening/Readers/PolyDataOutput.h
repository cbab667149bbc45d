// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/DataSet.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

namespace wirewarp
{
/// What was read, for VTK's pipelines.
/// \param shared the points of another data set of VTK that has the same; null: points of its own
vtkSmartPointer<vtkPolyData> polyDataOf(
  const flattening::DataSet& data, vtkPoints* shared = nullptr);

/// A table of VTK.
vtkSmartPointer<vtkTable> tableOf(const flattening::Columns& columns);

/// The way back.
flattening::DataSet dataSetOf(vtkPolyData* data);
}
