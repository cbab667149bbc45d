// SPDX-License-Identifier: BSD-3-Clause
// The options of patterns, each declared once, as those of the algorithms are in
// Options/OptionTable.h.
#pragma once

#include "Options/OptionValues.h"

#include <functional>
#include <vector>

namespace flattening::pattern
{
struct FileOptions;

struct PatternOption : Option
{
  /// Empty: of single curves or pieces, which front ends add one by one.
  std::function<void(FileOptions&, const OptionValue&)> setIn;
  std::function<OptionValue(FileOptions&)> valueIn; ///< there where setIn is
};

/// All options, ordered by group: "Drawing", what few need ("Details"), and what is of some formats
/// alone ("Cloth", "PDF", "SVG", "DXF"). A number and a list that share a spelling are one flag of
/// the command, MM or NAME=MM. Lengths are millimetres.
const std::vector<PatternOption>& patternOptionTable();

std::vector<const Option*> patternOptions();

/// Sets all members that are options of the table. \pre the values are those of patternOptions()
void setOptions(const OptionValues& values, FileOptions& options);
}
