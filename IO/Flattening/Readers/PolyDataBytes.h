// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <string_view>

namespace wirewarp
{
/// Points, cells and arrays as bytes of this machine, to go from one process to another.
std::string packPolyData(vtkPolyData* data);

/// The data of such bytes. Whatever the bytes are, the result is sound: cells name points that
/// exist. Arrays may be shorter than their points or cells: the filters leave such out and say so.
/// Throws std::runtime_error with words that tell the defect otherwise.
vtkSmartPointer<vtkPolyData> unpackPolyData(std::string_view bytes);
}
