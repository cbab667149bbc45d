// SPDX-License-Identifier: BSD-3-Clause
// How options and their values are written, and checked. Front ends may include this header: it
// needs the standard library alone.
#pragma once

#include "Options/Option.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace flattening
{
/// What a panel calls it: its label, or "Close Cuts" of CloseCuts.
std::string labelOf(const Option& option);

/// As "[0, 100]", "(0, 2)", "[0, inf)" or "from 1"; empty for options without numbers.
std::string rangeOf(const Option& option);

/// Whether numbers are within the range. \pre the value is of the option's type
bool isValid(const Option& option, const OptionValue& value);

/// Text, or the word, or numbers with blanks between them, as short as they are read back exactly.
std::string textOf(const Option& option, const OptionValue& value);

/// The same as filters print it: "On", or the name of a word.
std::string printed(const Option& option, const OptionValue& value);

/// How a message calls options.
enum class OptionSpelling
{
  Property, ///< CloseCuts, Scheme Isometric
  Command,  ///< --close-cuts, --scheme isometric
  Python,   ///< close_cuts, scheme='isometric'
};

/// A flag that is on by default is called by the one that turns it off: --no-arrange.
std::string spelled(const Option& option, OptionSpelling spelling);

/// An option with the value that a remedy names: "Solver = NEWTON", "--solver newton" or
/// "solver="newton"". \param property of the filters; of vtkSewnShape with "Sewing." before it
/// \param value may be empty
std::string spelledSetting(
  const std::string& property, const std::string& value, OptionSpelling spelling);

/// Values of all options of a filter, and which of them the user gave.
class OptionValues
{
public:
  explicit OptionValues(OptionOwner owner);
  explicit OptionValues(std::vector<const Option*> options);

  const std::vector<const Option*>& options() const { return this->Options; }
  /// \return the option of this name, or null.
  const Option* find(const std::string& property) const;
  const OptionValue& operator[](const std::string& property) const;
  /// \pre the value is of the option's type
  void set(const std::string& property, OptionValue value);

  /// \return whether the enumeration has the word
  bool setWord(const std::string& property, const std::string& word);

  bool flag(const std::string& property) const { return this->number(property) != 0.0; }
  int integer(const std::string& property) const
  {
    return static_cast<int>(this->number(property));
  }
  double number(const std::string& property) const { return std::get<double>((*this)[property]); }
  /// Of a text or list, or the word of an enumeration.
  std::string text(const std::string& property) const;
  const std::vector<std::string>& list(const std::string& property) const;

  void markGiven(const std::string& property) { this->Given.insert(property); }
  bool isGiven(const std::string& property) const { return this->Given.count(property) > 0; }

private:
  std::vector<const Option*> Options;
  std::map<std::string, OptionValue> Values;
  std::set<std::string> Given;
};

/// What is wrong with the first option that is given although it has no effect with the values of
/// the others; empty: nothing.
std::string describeIdleOption(const OptionValues& values, OptionSpelling spelling);
}
