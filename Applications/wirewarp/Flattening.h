// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FlagWords.h"
#include "Options.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace wirewarp
{
/// What became of one surface.
struct Flattening
{
  int exitCode = Done;
  /// "Ok", a status name of vtkFlatteningAlgorithm, or "UnreadableInput".
  std::string status = "Ok";
  std::string message;
  std::vector<vtkIdType> ids; ///< of the elements that the message is about
  std::string idKind;         ///< what they are: "points", "cells", "curves", ...
  std::vector<Remedy> remedies;

  /// The outputs of vtkWireWarpingFilter; without points after a refusal.
  vtkSmartPointer<vtkPolyData> flat;
  vtkSmartPointer<vtkPolyData> wires;
  vtkSmartPointer<vtkPolyData> cut;
  /// With --suggest: all curves, as vtkFeatureCurveSuggestion has them.
  vtkSmartPointer<vtkPolyData> curves;

  double secondsRead = 0.0;
  double secondsWrite = 0.0; ///< of all files but the report itself
  double secondsTotal = 0.0;

  bool refused() const { return this->exitCode == InputRefused; }
};

/// A refusal for want of memory.
Flattening outOfMemory(const std::string& surface);

/// Reads one surface with its curves and flattens it. Bad input ends in the result, not in an
/// exception.
Flattening flattenOne(const Options& options);
}
