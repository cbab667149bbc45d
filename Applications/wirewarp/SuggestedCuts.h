// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening.h"

#include <string>
#include <vector>

namespace wirewarp
{
/// A row of vtkFeatureCurveSuggestion's curves.
struct SuggestedCut
{
  long long type = 0;
  std::string name;
  double length = 0.0;
  double predictedGain = 0.0;
  double gain = 0.0;
  double opening = 0.0;
  double strainBefore = 0.0;
  double strainAfter = 0.0;
  std::string mirrorOf; ///< name of the cut that it is the mirror image of
};

/// What --suggest proposed; empty without it.
std::vector<SuggestedCut> suggestedCuts(const Flattening& result);

/// The same as a table, or that nothing is to be cut; empty without --suggest.
std::string suggestionTable(const Flattening& result);
}
