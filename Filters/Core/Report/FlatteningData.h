// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"
#include "Input/CurvedSurface.h"
#include "Input/DataSet.h"
#include "Suggestion/CurveSuggestions.h"
#include "Surface/FeatureCurve.h"

#include <string>
#include <vector>

namespace flattening
{
/// The arrays of a surface that are handed on: those with a value for each point or cell.
struct SurfaceArrays
{
  Columns points;
  Columns cells;
  Columns fields;

  SurfaceArrays() = default;
  /// \param warnings get a sentence for each array that is left out or changed
  SurfaceArrays(const DataSet& surface, std::vector<std::string>& warnings);
};

/// The outputs of vtkWireWarpingFilter.
struct FlatteningData
{
  DataSet flat;
  DataSet wires; ///< over the points of `flat`
  DataSet cut;
};

FlatteningData flatteningData(const SurfaceArrays& input, const CurvedSurface& source,
  const FlatteningResult& result, const FlatteningOptions& options);

/// Lines without arrays.
DataSet lineData(const std::vector<Points3>& lines);

/// The curves of the input, and then those proposed.
DataSet suggestionData(const std::vector<Polyline>& given, const CurveSuggestions& found);

/// The imprinted surface with its curves, over the same points.
struct ImprintData
{
  DataSet surface;
  DataSet curves;
};
ImprintData imprintData(const SurfaceArrays& input, const CurvedSurface& source);

/// A surface without the defects that healSurface() mends, as triangles. \return a sentence for
/// each kind of defect, and what is wrong where it cannot be healed; then it is as it was
std::vector<std::string> healData(const DataSet& surface, DataSet& healed);
}
