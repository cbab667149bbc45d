// SPDX-License-Identifier: BSD-3-Clause
// Remedies in the words of a user interface, which may include this header: it needs the standard
// library alone.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace flattening
{
/// A remedy by its name, as remedyName() gives it.
struct NamedRemedy
{
  std::string name;
  std::string subject; ///< what it is to be applied to; may be empty
};

/// The sentence of the remedy of a name, with the placeholders that Status.h explains; null where
/// there is none.
const char* remedySentence(const std::string& name);

/// A user interface's spelling of an option: of a property of the filters with the value that it is
/// to have, which may be empty. Empty where the user interface has no such option.
using Spelling = std::function<std::string(const std::string& property, const std::string& value)>;

/// The sentence of a remedy with % for the subject; empty where there is no remedy of the name, or
/// the user interface lacks an option that it needs.
std::string remedyWords(const std::string& name, const Spelling& spelling);

/// A defect and those of its remedies that the user interface has.
std::string describeDefect(
  const std::string& defect, const std::vector<NamedRemedy>& remedies, const Spelling& spelling);
}
