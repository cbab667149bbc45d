// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionValues.h"

#include "Options/OptionTable.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{
/// Number of an option with this value: the only one but for ids and components.
std::vector<double> numbersOf(const OptionValue& value)
{
  const double* const number = std::get_if<double>(&value);
  return number ? std::vector<double>{ *number } : std::get<std::vector<double>>(value);
}

std::string numberText(double number)
{
  char text[40];
  const bool whole = number == std::floor(number) && std::abs(number) < 1e15;
  for (int digits = whole ? 15 : 1; digits <= 17; ++digits)
  {
    std::snprintf(text, sizeof(text), "%.*g", digits, number);
    if (std::strtod(text, nullptr) == number)
    {
      break;
    }
  }
  return text;
}

/// With commas, or something else before the last.
std::string joined(const std::vector<std::string>& words, const std::string& last = ", ")
{
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
  {
    text += (k == 0 ? "" : k + 1 < words.size() ? ", " : last) + words[k];
  }
  return text;
}

bool holds(const OptionCondition& condition, const Option& other, const OptionValues& values)
{
  if (!condition.words.empty())
  {
    const std::string word = values.text(other.property);
    return std::find(condition.words.begin(), condition.words.end(), word) != condition.words.end();
  }
  return other.type == OptionType::Flag ? values.flag(other.property)
                                        : !values.text(other.property).empty();
}

/// How a word of an option is written: "--scheme lscm", "scheme='lscm'".
std::string setting(
  const Option& option, const std::vector<std::string>& words, OptionSpelling spelling)
{
  std::vector<std::string> shown;
  for (const std::string& word : words)
  {
    const auto known = std::find_if(option.words.begin(), option.words.end(),
      [&word](const OptionWord& one) { return one.word == word; });
    const bool named =
      spelling == OptionSpelling::Property && known != option.words.end() && !known->name.empty();
    shown.push_back(spelling == OptionSpelling::Python ? "'" + word + "'"
        : named                                        ? known->name
                                                       : word);
  }
  return spelled(option, spelling) + (spelling == OptionSpelling::Python ? "=" : " ") +
    joined(shown, " or ");
}

/// What the other option must be.
std::string wanted(const OptionCondition& condition, const Option& other, OptionSpelling spelling)
{
  if (other.type == OptionType::Flag)
  {
    return spelling == OptionSpelling::Command ? "pieces without " + spelled(other, spelling)
      : spelling == OptionSpelling::Python     ? spelled(other, spelling) + "=True"
                                               : spelled(other, spelling) + " on";
  }
  if (condition.words.empty())
  {
    return spelling == OptionSpelling::Command ? spelled(other, spelling) + " " + other.form
                                               : "a " + spelled(other, spelling);
  }
  std::vector<std::string> words = condition.words;
  const bool none = words.front().empty();
  words.erase(words.begin(), words.begin() + (none ? 1 : 0));
  return (none ? "a sheet without " + spelled(other, spelling) + " or with " : "") +
    setting(other, words, spelling);
}
}

std::string spellingOf(const std::string& property)
{
  std::string words;
  for (const char letter : property)
  {
    const bool capital = std::isupper(static_cast<unsigned char>(letter)) != 0;
    words += capital && !words.empty() ? "-" : "";
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  for (const auto& [whole, part] : { std::pair("maximum", "max"), std::pair("minimum", "min") })
  {
    const std::size_t place = words.find(whole);
    if (place != std::string::npos)
    {
      words.replace(place, std::string(whole).size(), part);
    }
  }
  return words;
}

std::string labelOf(const Option& option)
{
  std::string text = option.label;
  for (const char letter : option.label.empty() ? option.property : std::string())
  {
    text += !text.empty() && std::isupper(static_cast<unsigned char>(letter)) ? " " : "";
    text += letter;
  }
  return text;
}

std::string rangeOf(const Option& option)
{
  if (option.minimum == option.maximum)
  {
    return "";
  }
  if (option.type == OptionType::Integer)
  {
    const bool above = option.maximum < std::numeric_limits<int>::max();
    return "from " + numberText(option.minimum) +
      (above ? " to " + numberText(option.maximum) : "");
  }
  const bool endless = option.maximum == std::numeric_limits<double>::max();
  return (option.open ? "(" : "[") + numberText(option.minimum) + ", " +
    (endless ? "inf" : numberText(option.maximum)) + (option.open || endless ? ")" : "]");
}

bool isValid(const Option& option, const OptionValue& value)
{
  if (option.minimum == option.maximum)
  {
    return true;
  }
  const std::vector<double> numbers = numbersOf(value);
  return std::all_of(numbers.begin(), numbers.end(), [&option](double number) {
    return std::isfinite(number) &&
      (option.open ? number > option.minimum && number < option.maximum
                   : number >= option.minimum && number <= option.maximum);
  });
}

std::string textOf(const Option& option, const OptionValue& value)
{
  if (const std::string* const text = std::get_if<std::string>(&value))
  {
    return *text;
  }
  if (const auto* const list = std::get_if<std::vector<std::string>>(&value))
  {
    return joined(*list);
  }
  if (option.type == OptionType::Word)
  {
    return option.words[static_cast<std::size_t>(std::get<double>(value))].word;
  }
  std::string text;
  for (const double number : numbersOf(value))
  {
    text += (text.empty() ? "" : " ") + numberText(number);
  }
  return text;
}

std::string printed(const Option& option, const OptionValue& value)
{
  if (option.type == OptionType::Flag)
  {
    return std::get<double>(value) != 0.0 ? "On" : "Off";
  }
  return option.type == OptionType::Word
    ? option.words[static_cast<std::size_t>(std::get<double>(value))].name
    : textOf(option, value);
}

std::string spelled(const Option& option, OptionSpelling spelling)
{
  if (spelling == OptionSpelling::Property)
  {
    return option.property;
  }
  if (spelling == OptionSpelling::Python)
  {
    std::string text = option.argument.empty() ? option.spelling : option.argument;
    std::replace(text.begin(), text.end(), '-', '_');
    return text;
  }
  const bool off = option.type == OptionType::Flag && std::get<double>(option.byDefault) != 0.0;
  return "--" +
    (!off                            ? option.spelling
        : option.spellingOff.empty() ? "no-" + option.spelling
                                     : option.spellingOff);
}

std::string spelledSetting(
  const std::string& property, const std::string& value, OptionSpelling spelling)
{
  const std::string sewing = "Sewing.";
  const bool sews = property.rfind(sewing, 0) == 0;
  const std::string name = property.substr(sews ? sewing.size() : 0);
  if (spelling == OptionSpelling::Property)
  {
    return name + (value.empty() ? "" : " = " + value);
  }
  Option plain; // of patterns, or an array
  plain.spelling = spellingOf(name);
  const Option* const known =
    findOption(sews ? OptionOwner::Sewing : OptionOwner::Suggestion, name);
  const Option& option = known ? *known : plain;
  const std::string spelledName = spelled(option, spelling);
  if (value.empty() || value == "on")
  {
    return spelledName + (!value.empty() && spelling == OptionSpelling::Python ? "=True" : "");
  }
  const auto letters = [](std::string text) {
    text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
    std::transform(text.begin(), text.end(), text.begin(),
      [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
  };
  std::string word = letters(value);
  for (const OptionWord& one : option.words)
  {
    word = letters(one.name) == letters(value) ? one.word : word;
  }
  return spelledName + (spelling == OptionSpelling::Python ? "=\"" + word + '"' : ' ' + word);
}

OptionValues::OptionValues(OptionOwner owner)
  : OptionValues(optionsOf(owner))
{
}

OptionValues::OptionValues(std::vector<const Option*> options)
  : Options(std::move(options))
{
  for (const Option* const option : this->Options)
  {
    this->Values.emplace(option->property, option->byDefault);
  }
}

const Option* OptionValues::find(const std::string& property) const
{
  const auto found = std::find_if(this->Options.begin(), this->Options.end(),
    [&property](const Option* option) { return option->property == property; });
  return found == this->Options.end() ? nullptr : *found;
}

const OptionValue& OptionValues::operator[](const std::string& property) const
{
  return this->Values.at(property);
}

void OptionValues::set(const std::string& property, OptionValue value)
{
  this->Values.at(property) = std::move(value);
}

bool OptionValues::setWord(const std::string& property, const std::string& word)
{
  const std::vector<OptionWord>& words = this->find(property)->words;
  const auto found = std::find_if(
    words.begin(), words.end(), [&word](const OptionWord& one) { return one.word == word; });
  if (found == words.end())
  {
    return false;
  }
  this->set(property, static_cast<double>(found - words.begin()));
  return true;
}

std::string OptionValues::text(const std::string& property) const
{
  return textOf(*this->find(property), (*this)[property]);
}

const std::vector<std::string>& OptionValues::list(const std::string& property) const
{
  return std::get<std::vector<std::string>>((*this)[property]);
}

std::string describeIdleOption(const OptionValues& values, OptionSpelling spelling)
{
  for (const Option* const option : values.options())
  {
    if (!values.isGiven(option->property))
    {
      continue;
    }
    for (const OptionCondition& condition : option->conditions)
    {
      const Option& other = *values.find(condition.property);
      if (holds(condition, other, values))
      {
        continue;
      }
      const std::string name = spelled(*option, spelling);
      std::string text = name + " is for " + wanted(condition, other, spelling);
      if (other.type != OptionType::Flag && !values.text(other.property).empty())
      {
        text += ", not for " + setting(other, { values.text(other.property) }, spelling);
      }
      text += values.isGiven(other.property) ? "; leave one of them out"
                                             : "; give that as well, or leave " + name + " out";
      return text;
    }
  }
  return "";
}
}
