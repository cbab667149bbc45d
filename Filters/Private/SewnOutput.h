// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sewing/PieceSewing.h"
#include "SewnInput.h"

#include "vtkSmartPointer.h"

class vtkTable;

namespace flattening
{
namespace bridge
{
/// Writes what vtkSewnShape documents.
/// \param design the input in space. \param sewn its output 0. \param designed its output 1.
/// \param shapes its output 2
void writeSewn(vtkPolyData* design, const SewnInput& input, const SewingResult& result,
  vtkPolyData* sewn, vtkPolyData* designed, vtkTable* shapes, std::vector<std::string>& warnings);

/// One row per iteration.
vtkSmartPointer<vtkTable> sewingIterations(const SewingResult& result);
}
}
