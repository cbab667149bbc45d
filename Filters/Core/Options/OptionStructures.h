// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Imprint/ImprintedSurface.h"
#include "Reshaping/FlattenableSurface.h"
#include "Sewing/PieceSewing.h"
#include "Suggestion/CurveSuggestions.h"
#include "Surface/SurfaceHealing.h"
#include "Surface/SurfacePreparation.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace flattening
{
/// The structures that the options of the table are members of: their defaults are the project's.
struct OptionStructures
{
  CoincidentPoints coincidentPoints = CoincidentPoints::Automatic;
  bool healSurface = true;
  bool proposes = false; ///< cuts, which also may run where more than two triangles meet
  ImprintOptions imprint;
  FlatteningOptions flattening;
  SearchOptions search;
  FlattenableOptions reshaping;
  SewingOptions sewing;

  Defects defects() const
  {
    return !this->healSurface ? Defects::Refuse
      : this->proposes        ? Defects::Separate
                              : Defects::Heal;
  }
};

/// The value of a number, flag, enumeration, text, or range of numbers.
/// \tparam Value an OptionValue
template <class Value, class Member>
Value optionValueOf(const Member& member)
{
  if constexpr (std::is_arithmetic_v<Member> || std::is_enum_v<Member>)
  {
    return static_cast<double>(member);
  }
  else if constexpr (std::is_same_v<Member, std::string>)
  {
    return member;
  }
  else
  {
    return std::vector<double>(std::begin(member), std::end(member));
  }
}

/// \pre the value is of the member's type
template <class Member, class Value>
void assignOption(Member& member, const Value& value)
{
  if constexpr (std::is_same_v<Member, bool>)
  {
    member = std::get<double>(value) != 0.0;
  }
  else if constexpr (std::is_arithmetic_v<Member>)
  {
    member = static_cast<Member>(std::get<double>(value));
  }
  else if constexpr (std::is_enum_v<Member>)
  {
    member = static_cast<Member>(static_cast<int>(std::get<double>(value)));
  }
  else if constexpr (std::is_same_v<Member, std::string>)
  {
    member = std::get<std::string>(value);
  }
  else
  {
    using Number = std::remove_reference_t<decltype(*std::begin(member))>;
    const std::vector<double>& numbers = std::get<std::vector<double>>(value);
    std::transform(numbers.begin(), numbers.end(), std::begin(member),
      [](double number) { return static_cast<Number>(number); });
  }
}
}
