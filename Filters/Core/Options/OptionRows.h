// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/Option.h"
#include "Options/OptionStructures.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace flattening
{
template <class Member>
constexpr OptionType optionTypeOf()
{
  return std::is_same_v<Member, bool>     ? OptionType::Flag
    : std::is_enum_v<Member>              ? OptionType::Word
    : std::is_integral_v<Member>          ? OptionType::Integer
    : std::is_floating_point_v<Member>    ? OptionType::Number
    : std::is_same_v<Member, std::string> ? OptionType::Text
    : std::is_same_v<Member, Point3>      ? OptionType::Numbers
                                          : OptionType::Ids;
}

/// Fills in a row of a table of options.
class OptionRow
{
public:
  explicit OptionRow(Option& option)
    : Kept(&option)
  {
  }

  /// \param argument where Python has another name
  OptionRow& spelled(const char* spelling, const char* argument = "")
  {
    return this->with(&Option::spelling, spelling).with(&Option::argument, argument);
  }
  OptionRow& help(const char* text) { return this->with(&Option::help, text); }
  /// What the command's flag does that turns this off, and its name where that is not no-SPELLING.
  OptionRow& off(const char* text, const char* spelling = "")
  {
    return this->with(&Option::helpOff, text).with(&Option::spellingOff, spelling);
  }
  OptionRow& form(const char* text) { return this->with(&Option::form, text); }
  OptionRow& words(std::vector<OptionWord> all)
  {
    return this->with(&Option::words, std::move(all));
  }
  /// What it means depends on the input of the filter.
  OptionRow& byFilter() { return this->with(&Option::set, nullptr); }
  /// Where the option's default is not the structure's.
  OptionRow& byDefault(const char* word)
  {
    const std::vector<OptionWord>& words = this->Kept->words;
    const auto found = std::find_if(
      words.begin(), words.end(), [word](const OptionWord& one) { return one.word == word; });
    return this->with(&Option::byDefault, static_cast<double>(found - words.begin()));
  }
  OptionRow& label(const char* text) { return this->with(&Option::label, text); }
  OptionRow& automatic(const char* text) { return this->with(&Option::automatic, text); }
  OptionRow& expert() { return this->with(&Option::expert, true); }

  OptionRow& range(double least, double most)
  {
    this->Kept->minimum = least;
    this->Kept->maximum = most;
    return this->slider(least, most);
  }
  /// Without the ends.
  OptionRow& within(double least, double most)
  {
    this->Kept->open = true;
    return this->range(least, most);
  }
  OptionRow& slider(double least, double most)
  {
    this->Kept->sliderMinimum = least;
    this->Kept->sliderMaximum = most;
    return *this;
  }
  OptionRow& where(const OptionCondition& condition)
  {
    this->Kept->conditions.push_back(condition);
    return *this;
  }

private:
  template <class Member, class Value>
  OptionRow& with(Member Option::*member, Value&& value)
  {
    this->Kept->*member = std::forward<Value>(value);
    return *this;
  }

  Option* Kept;
};

/// The rows of a table while it is filled.
/// \tparam Entry an Option
/// \tparam Structures what the options are members of
/// \tparam set the member of Entry that assigns a value to the structures
/// \tparam get that which reads it; null: none
template <class Entry, class Structures, auto set, auto get = nullptr>
class OptionRows
{
public:
  /// The rows that follow are of this filter and stand under this heading.
  void group(OptionOwner owner, const char* heading)
  {
    this->Owner = owner;
    this->Heading = heading;
  }

  /// An option that is a member of the structures.
  template <class Access>
  OptionRow add(const char* property, Access access)
  {
    using Member = std::remove_pointer_t<decltype(access(std::declval<Structures&>()))>;
    Entry& option = this->append(property, optionTypeOf<Member>());
    Structures defaults;
    option.byDefault = optionValueOf<OptionValue>(*access(defaults));
    option.*set = [access](Structures& structures, const OptionValue& value) {
      assignOption(*access(structures), value);
    };
    if constexpr (std::is_member_pointer_v<decltype(get)>)
    {
      option.*get = [access](Structures& structures) {
        return optionValueOf<OptionValue>(*access(structures));
      };
    }
    return OptionRow(option);
  }

  /// An option that the filter reads itself, empty by default.
  OptionRow text(const char* property, OptionType type = OptionType::Text)
  {
    Option& option = this->append(property, type);
    if (type == OptionType::List)
    {
      option.byDefault = std::vector<std::string>();
    }
    else
    {
      option.byDefault = std::string();
    }
    return OptionRow(option);
  }

  std::vector<Entry> Rows;

private:
  Entry& append(const char* property, OptionType type)
  {
    Entry& option = this->Rows.emplace_back();
    option.owner = this->Owner;
    option.property = property;
    option.spelling = spellingOf(property);
    option.type = type;
    option.group = this->Heading;
    return option;
  }

  OptionOwner Owner = OptionOwner::Curves;
  std::string Heading;
};
}
