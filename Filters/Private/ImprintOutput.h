// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedPolyData.h"

namespace flattening::bridge
{
/// Writes an imprinted surface and its curves as the two outputs that vtkFeatureCurveImprinter
/// documents. \param warnings get a sentence for each array of the curves that is left out.
void writeImprint(const CurvedPolyData& source, vtkPolyData* surface, vtkPolyData* curves,
  std::vector<std::string>& warnings);
}
