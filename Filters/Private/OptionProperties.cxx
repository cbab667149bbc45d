// SPDX-License-Identifier: BSD-3-Clause
#include "OptionProperties.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace flattening::bridge
{
void setNumber(vtkObject* owner, OptionValues& values, const char* property, double number)
{
  const Option& option = *values.find(property);
  double within = number;
  if (!option.words.empty())
  {
    // A word without a name is a class of its own.
    const auto names = std::count_if(option.words.begin(), option.words.end(),
      [](const OptionWord& word) { return !word.name.empty(); });
    within = std::clamp(number, 0.0, static_cast<double>(names - 1));
  }
  else if (option.minimum != option.maximum && !option.open && !std::isnan(number))
  {
    const double least = std::min(option.minimum, std::get<double>(option.byDefault));
    within = std::min(std::max(number, least), option.maximum);
  }
  if (within != values.number(property))
  {
    values.set(property, within);
    owner->Modified();
  }
}

void setText(vtkObject* owner, OptionValues& values, const char* property, const std::string& text)
{
  if (text != std::get<std::string>(values[property]))
  {
    values.set(property, text);
    owner->Modified();
  }
}

const char* nameOfWord(const OptionValues& values, const char* property)
{
  return values.find(property)
    ->words[static_cast<std::size_t>(values.integer(property))]
    .name.c_str();
}

void print(const OptionValues& values, std::ostream& os, vtkIndent indent)
{
  for (const Option* const option : values.options())
  {
    if (option->type != OptionType::List)
    {
      os << indent << option->property << ": " << printed(*option, values[option->property])
         << "\n";
    }
  }
}
}
