// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

namespace flattening
{
struct Status;
}

namespace wirewarp
{
/// A remedy of a defect as the filters name it.
struct Remedy
{
  std::string name;
  std::string subject; ///< what it is to be applied to; may be empty
};

/// A program's spelling of an option: of a property of the filters (see
/// vtkFlatteningAlgorithm::GetRemedySentence()) with the value that it is to have, which may be
/// empty. Empty where the program has no such option.
using Spelling = std::function<std::string(const std::string& property, const std::string& value)>;

/// Of "Property" or "Property=VALUE".
struct SpelledOption
{
  const char* option;
  const char* words;
};
using SpellingTable = std::initializer_list<SpelledOption>;

/// The words of the first row that has the property, alone or with this value; empty where none
/// has.
std::string findSpelling(
  const SpellingTable& table, const std::string& property, const std::string& value);

/// The sentence of a remedy in the program's spelling, with % for the subject; empty where the
/// program lacks an option that it needs.
std::string remedyWords(const std::string& name, const Spelling& spelling);

/// A defect and those of its remedies that the program has.
std::string describe(
  const std::string& defect, const std::vector<Remedy>& remedies, const Spelling& spelling);

/// The remedies of a status.
std::vector<Remedy> remediesOf(const flattening::Status& status);
}
