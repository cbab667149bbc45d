// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"
#include "Input/Columns.h"
#include "Input/MappedSurface.h"
#include "Sewing/PieceSewing.h"

#include <string>
#include <vector>

namespace flattening
{
/// Flat pieces and the cut surface that they are of, with the seams between them.
struct SewnInput
{
  MappedSurface map;
  CutSurface cut; ///< vertices and triangles are those of the map's mesh
  Status outcome;
};

/// \param seams the field array `SeamPairs` of the flat pieces; null: nothing is sewn
SewnInput makeSewnInput(MappedSurface map, const Column* seams);

/// What vtkSewnShape documents beside the arrays of the design.
struct SewnArrays
{
  Points3 points;        ///< of the design, moved to where they lie at rest
  Column distance;       ///< of the points of the sewn cloth, `Distance`
  Column designDistance; ///< the same of the design
  Columns cellArrays;    ///< of the triangles of the input
  Columns fieldArrays;   ///< `SeamPairs`, `SeamStrains`
  Columns shapes;        ///< a row each
  Columns iterations;    ///< of all shapes
  std::vector<std::string> warnings;
};

/// \param design the points of the input
SewnArrays sewnArrays(const Points3& design, const SewnInput& input, const SewingResult& result);
}
