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
  std::string type;
  std::string name;
  double length = 0.0;
  double predictedGain = 0.0;
  double gain = 0.0;
  double opening = 0.0;
  double areaErrorBefore = 0.0;
  double areaErrorAfter = 0.0;
  double strainBefore = 0.0;
  double strainAfter = 0.0;
  std::string mirrorOf; ///< name of the cut that it is the mirror image of
};

/// A line that was tried and not proposed.
struct LeftOutLine : SuggestedCut
{
  bool sound = true; ///< it only costs too much
};

/// What --suggest proposed; empty without it.
std::vector<SuggestedCut> suggestedCuts(const Flattening& result);
std::vector<LeftOutLine> leftOutLines(const Flattening& result);

/// The numbers of MirrorPlane or MirrorAxis; none where there is no such mirror.
std::vector<double> mirrorNumbers(const Flattening& result, const char* array);

/// Both as tables, or that nothing is proposed; empty without --suggest.
std::string suggestionTable(const Flattening& result);
}
