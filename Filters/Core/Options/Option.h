// SPDX-License-Identifier: BSD-3-Clause
// An option of a filter. Front ends may include this header: it needs the standard library alone.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace flattening
{
struct OptionStructures;

/// The filter that has an option as a property; the class is named by className().
enum class OptionOwner
{
  Curves,     ///< what all filters on surfaces and curves have
  Pieces,     ///< beside those of Curves, what all have that give flat pieces
  Warping,    ///< beside those of Pieces
  Suggestion, ///< beside those of Warping
  Reshaping,  ///< beside those of Warping
  Conformal,  ///< beside those of Pieces
  Sewing,
  Pattern, ///< of drawn patterns, whose table is not in Core
};

enum class OptionType
{
  Flag,
  Integer,
  Number,
  Word,    ///< one of an enumeration; its value is the place
  Text,    ///< read when a run begins
  List,    ///< texts that Add methods of the filter take one by one
  Ids,     ///< two points
  Numbers, ///< three components
};

/// Flags and words are numbers as well.
using OptionValue =
  std::variant<double, std::string, std::vector<double>, std::vector<std::string>>;

struct OptionWord
{
  std::string word; ///< of command and Python
  std::string name; ///< that the filter's Get...AsString() returns; empty: a class of its own
};

/// Another option has one of these words, or without words is on or not empty.
struct OptionCondition
{
  std::string property;
  std::vector<std::string> words;
};

struct Option
{
  OptionOwner owner = OptionOwner::Curves;
  std::string property; ///< of the filter, as "CloseCuts"
  std::string spelling; ///< of the command without dashes at its start, as "close-cuts"
  std::string argument; ///< of Python, as "close_cuts"
  OptionType type = OptionType::Flag;
  std::vector<OptionWord> words;
  double minimum = 0.0;
  double maximum = 0.0;
  bool open = false; ///< the range is without its ends
  double sliderMinimum = 0.0;
  double sliderMaximum = 0.0; ///< of a panel, where the range is too wide for it
  std::string form;           ///< of a text or list, as "NAME=FRACTION"
  std::string group;          ///< heading of a help or a panel
  std::string label;          ///< of a panel; empty: the property in words
  bool expert = false;
  std::vector<OptionCondition> conditions; ///< all must hold that the option has an effect
  std::string help;                        ///< a sentence or two, without range and default
  std::string spellingOff; ///< of the command's flag that turns this off; empty: no-SPELLING
  std::string helpOff; ///< what a flag does that turns this off; for flags that are on by default
  /// What is taken of a number that is not given, where that follows from the input; it is -1 then.
  std::string automatic;
  OptionValue byDefault;
  std::function<void(OptionStructures&, const OptionValue&)> set; ///< empty: the filter reads it
};

/// "CloseCuts" as "close-cuts", "MaximumCuts" as "max-cuts".
std::string spellingOf(const std::string& property);
}
