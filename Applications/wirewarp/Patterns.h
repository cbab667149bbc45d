// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PatternOptions.h"

#include <string>
#include <vector>

class vtkFeatureCurveAlgorithm;

namespace wirewarp
{
struct Flattening;
class OutputFiles;

/// Before the surface is flattened: refuses options for curves that are not there.
/// \param filter which has the curves, and may propose others
void checkCurveNames(const PatternRequest& request, const std::string& surface,
  vtkFeatureCurveAlgorithm* filter, Flattening& result);

/// Adds the files of a pattern. Throws InputError where one cannot be drawn. What was done goes
/// into the result, and is printed where it is news: not what was done unasked, and if quiet only
/// what was asked for in vain.
/// \return those that are written
std::vector<std::string> addPatterns(const PatternRequest& request, const std::string& surface,
  bool quiet, Flattening& result, OutputFiles& files);
}
