// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"
#include "QualityInput.h"

namespace flattening
{
namespace bridge
{
/// Flat pieces and the cut surface that they are of, with the seams between them.
struct SewnInput
{
  MappedSurface map;
  CutSurface cut; ///< vertices and triangles are those of the map's mesh
  Status outcome;
};

/// \param flat pieces with the field data `SeamPairs`; without it nothing is sewn
/// \param design the cut surface in space, point for point and cell for cell
SewnInput loadSewnInput(vtkPolyData* flat, vtkPolyData* design);
}
}
