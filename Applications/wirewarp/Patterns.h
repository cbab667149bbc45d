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

/// The files that are asked for.
/// \param graded in several sizes
/// \param folder of files without a name of their own
std::vector<PatternFile> patternFiles(
  const PatternRequest& request, bool graded, const std::string& folder);

/// Before the surface is flattened: refuses options for curves that are not there.
/// \param filter which has the curves, and may propose others
void checkCurveNames(const PatternRequest& request, const std::string& surface,
  vtkFeatureCurveAlgorithm* filter, Flattening& result);

/// Why the files of a pattern cannot be made of flat pieces, or nothing. No file is left.
/// \param times multiplies the width of the cloth and the number of pages
std::string layoutProblem(const PatternRequest& request, const std::string& surface, int times,
  const Flattening& result, const std::string& folder, OutputFiles& files);

/// Adds the files of a pattern. Throws InputError where one cannot be drawn. What was done goes
/// into the result, and is printed where it is news: not what was done unasked, and if quiet only
/// what was asked for in vain.
/// \return those that are written
std::vector<std::string> addPatterns(const PatternRequest& request, const std::string& surface,
  bool quiet, Flattening& result, const std::string& folder, OutputFiles& files);
}
