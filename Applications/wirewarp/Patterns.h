// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairBorders.h"
#include "Formats/PatternFile.h"
#include "Formats/PatternOptionTable.h"
#include "Input/CurvedSurface.h"
#include "Input/DataSet.h"
#include "Options/OptionStructures.h"
#include "Options/OptionValues.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
}

namespace wirewarp
{
struct Flattening;
struct Options;
class OutputFiles;

/// A file of a pattern.
struct PatternFile
{
  std::string path;
  flattening::pattern::FileFormat format;
  bool onCloth = false; ///< its pieces are laid on cloth
};

/// Which patterns to write and how.
struct PatternRequest
{
  std::vector<PatternFile> files;
  flattening::OptionValues values{ flattening::pattern::patternOptions() };
  std::vector<std::pair<std::string, int>> pieces; ///< names or none, and copies or 0
  std::string size;

  bool any() const { return !this->files.empty(); }
};

/// How pieces are drawn.
void addDrawing(CLI::App& app, PatternRequest& request);
/// How they are laid on cloth.
void addNesting(CLI::App& app, PatternRequest& request);

/// Before the surface is flattened: refuses options for curves that are not there, and pages that
/// cannot hold the surface.
/// \param curves of the surface, beside which others may be proposed
void checkPattern(const Options& options, const flattening::DataSet& surface,
  flattening::CurveInput curves, const flattening::OptionStructures& settings, Flattening& result);

/// Adds the files of a pattern. Throws InputError where one cannot be drawn. What was done goes
/// into the result, and is printed where it is news: not what was done unasked, and if quiet only
/// what was asked for in vain.
/// \return those that are written
std::vector<std::string> addPatterns(
  const Options& options, Flattening& result, OutputFiles& files);
}
