// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options.h"
#include "Options/OptionStructures.h"
#include "Options/OptionValues.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

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

/// Checks that an option is a number within bounds. \param range the bounds in words: "[0, 1]".
CLI::Validator number(double least, double most, const std::string& range);

/// Converts a length that may have a unit to millimetres; without one it is in mm.
/// \param isValid of millimetres \param range what is valid in words
CLI::Validator length(std::function<bool(double)> isValid, const std::string& range);

/// The same as number() for a whole one. \param range as "from 1".
CLI::Validator wholeNumber(long long least, long long most, const std::string& range);

/// Adds the options of how surfaces are flattened.
void addMethods(CLI::App& app, Options& options);

/// Core's options, without the cloth.
flattening::OptionStructures structuresOf(const Options& options);

/// The options with lengths of the surface in its unit.
Options withLengthsIn(const std::string& unit, Options options);

/// Of values of another class of options those that both have.
void takeOptions(const flattening::OptionValues& values, flattening::OptionOwner owner,
  flattening::OptionStructures& structures);

/// --tolerance by names of curves, and --pins.
std::map<std::string, double> tolerancesOf(const Options& options);
std::array<std::int64_t, 2> pinsOf(const Options& options);

/// Adds the options of how cuts are proposed.
void addCutting(CLI::App& app, Options& options);
}
