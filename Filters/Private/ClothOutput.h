// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningResult.h"

class vtkCellData;
class vtkFieldData;

namespace flattening
{
namespace bridge
{
/// What vtkWireWarpingFilter documents of threads; nothing where there is no material.
void writeThreads(const FlatteningResult& result, vtkCellData* cells);
void writeClothReports(const FlatteningResult& result, vtkFieldData* field);
}
}
