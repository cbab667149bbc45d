// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningResult.h"

class vtkCellData;
class vtkFieldData;

namespace flattening
{
namespace bridge
{
/// The cell arrays of threads; none where there is no material.
void writeThreads(const FlatteningResult& result, vtkCellData* cells);

/// `GrainAngle` of each piece, by which patterns know that pieces lie on a material.
void writeGrain(const FlatteningResult& result, vtkFieldData* field);
}
}
