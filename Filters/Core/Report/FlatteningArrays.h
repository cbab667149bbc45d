// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"
#include "Input/Columns.h"
#include "Input/CurvedSurface.h"

#include <string>
#include <vector>

namespace flattening
{
/// The points and triangles of a cut surface with their arrays beside those of the input.
struct CutArrays
{
  Indices originalVertex; ///< of the imprinted surface, that each point is a copy of
  Points3 points;
  Columns pointArrays; ///< `vtkOriginalPointIds`
  Columns cellArrays;  ///< `vtkOriginalCellIds`, `PieceId`
};

CutArrays cutArrays(const CurvedSurface& source, const CutSurface& cut);

/// The arrays that vtkWireWarpingFilter documents. Behind the vertices of the cut surface come the
/// points of the input that healing joined to another, at its place, which no triangle uses: so
/// each point of the input has a flat place.
struct FlatteningArrays : CutArrays
{
  Points2 positions;
  Columns fieldArrays; ///< those without rows are to replace others of the input
  Columns wireArrays;
};

FlatteningArrays flatteningArrays(
  const CurvedSurface& source, const FlatteningResult& result, const FlatteningOptions& options);

/// `SeamPairs`, edges that are sewn together.
Column seamPairs(const CutSurface& cut);

/// Adds `HomogeneityOfDistortion`, `AspectRatio`, `AreaRatio`, `AngleError` and `Flipped`.
void addTriangleQuality(const std::vector<TriangleQuality>& quality, Columns& cells);

/// `CurveType`, `CurveId`, `CurveName`, `PieceId`, `Boundary` and `RestLength`.
Columns wireArrays(const std::vector<Wire>& wires, const std::vector<FeatureCurve>& curves);

/// A sentence that names the pieces that were left out, by cells of the input.
std::string describeLeftOut(const CurvedSurface& source, const FlatteningResult& result);
}
