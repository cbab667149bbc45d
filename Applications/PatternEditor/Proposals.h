// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pieces.h"

#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

class vtkFeatureCurveEditor;

namespace editor
{
/// A cut that vtkFeatureCurveSuggestion proposes.
struct Proposal
{
  std::string name;
  int type = 0; ///< vtkFeatureCurveAlgorithm::CurveTypes
  vtkSmartPointer<vtkPoints> points;
  double length = 0.0;
  double strainBefore = 0.0; ///< the largest StrainP95 without it and those after it
  double strainAfter = 0.0;
};

struct Proposals
{
  std::vector<Proposal> cuts;
  std::string message; ///< what was refused or is left; empty where the bound is met
  bool stopped = false;
  std::string mirror; ///< what the surface is mirrored across, in words; empty: nothing
};

/// Looks for cuts of a surface with curves. \param weights the cell array that says how much
/// distortion matters where; empty: everywhere alike \param goOn gets what is being done, and says
/// whether to go on \param preview gets the cuts found so far, as lines
Proposals propose(vtkPolyData* surface, vtkPolyData* curves, const std::string& weights,
  const std::function<bool(const std::string&)>& goOn,
  const std::function<void(vtkPolyData*)>& preview);

/// The cell arrays of a surface that can be weights: a number a cell, none below 0.
std::vector<std::string> weightArrays(vtkPolyData* surface);

/// Adds a proposed cut to the curves, with few nodes; undone as one. False where it is refused.
bool accept(const Proposal& proposal, vtkFeatureCurveEditor* curves);

/// As lines to look at.
figures::PolyData linesOf(const std::vector<Proposal>& proposals);
}
