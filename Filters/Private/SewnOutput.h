// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sewing/PieceSewing.h"
#include "SewnInput.h"

namespace flattening
{
namespace bridge
{
/// Writes what vtkSewnShape documents.
/// \param design the input in space. \param sewn its output 0. \param designed its output 1.
void writeSewn(vtkPolyData* design, const SewnInput& input, const SewingResult& result,
  vtkPolyData* sewn, vtkPolyData* designed, std::vector<std::string>& warnings);
}
}
