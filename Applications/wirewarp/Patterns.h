// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PatternOptions.h"

#include <string>
#include <vector>

namespace wirewarp
{
struct Flattening;
class OutputFiles;

/// Adds pattern.svg, pattern.pdf, pattern.dxf, pattern.plt, pattern.json, walk.csv, lay.svg,
/// lay.plt, nest.svg, rules.csv and pattern.rul to the files.
/// Throws InputError where one cannot be drawn. What was done goes into the result, and is printed
/// where it is news: not what was done unasked, and if quiet only what was asked for in vain.
/// \return their names
std::vector<std::string> addPatterns(const PatternRequest& request, const std::string& surface,
  bool quiet, Flattening& result, OutputFiles& files);
}
