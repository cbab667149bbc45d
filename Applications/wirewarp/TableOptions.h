// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/OptionTable.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
class Option;
}

namespace wirewarp
{
/// Some of the table's options, as a command has them.
struct TableSubset
{
  std::string group;                  ///< of the table
  std::set<std::string> leftOut = {}; ///< properties
};

/// Adds options of the table, with the values as defaults. What is given is checked by type, range
/// and words, set in the values and marked as given there. \param values must outlive the parsing.
/// \return the options added
std::vector<CLI::Option*> addOptions(
  CLI::App& app, const TableSubset& subset, flattening::OptionValues& values);

/// An entry of a list NAME=FRACTION or NAME=WEIGHT. Throws CLI::ValidationError.
std::pair<std::string, double> namedNumber(
  const std::string& entry, const flattening::Option& option);

/// A curve that is longer in one piece than on the surface.
struct EaseRequest
{
  std::string curve;
  int piece = -1; ///< from 0; -1: the only one
  double fraction = 0.0;
};

/// NAME:PIECE=+3%, where a name may hold both signs. Throws CLI::ValidationError.
EaseRequest easeRequest(const std::string& entry);
}
