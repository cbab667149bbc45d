// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SearchOptions.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
Status checkSearch(const SearchOptions& options, const std::vector<Polyline>& curves)
{
  const auto refusal = [](const std::string& message, const std::string& wanted) {
    return Status{ StatusCode::InvalidOption, message, {}, { { Remedy::Give, wanted } } };
  };
  if (!std::isfinite(options.bound) || options.bound < 0.0 || options.bound >= 1.0)
  {
    return refusal(
      "the bound of the strain is " + shortNumber(options.bound), "a number from 0 to below 1");
  }
  if (std::isnan(options.maximumCutLength) || options.maximumCutLength <= 0.0)
  {
    return refusal("the greatest length of cuts is " + shortNumber(options.maximumCutLength),
      "a length above 0");
  }
  if (options.maximumCuts < 1)
  {
    return refusal("the greatest number of cuts is below 1", "a number from 1");
  }
  if (!std::isfinite(options.maximumWork) || options.maximumWork < 0.0)
  {
    return refusal(
      "the limit of work is " + shortNumber(options.maximumWork), "a number from 0, 0 for none");
  }
  for (const SearchOptions::Preference& preference : options.preferences)
  {
    const bool known = std::any_of(curves.begin(), curves.end(),
      [&](const Polyline& curve) { return curve.name == preference.curve; });
    if (!known)
    {
      return refusal("no curve is named \"" + preference.curve + "\"", "the name of a curve");
    }
    if (!std::isfinite(preference.weight) || preference.weight < 0.0)
    {
      return refusal(
        "the weight of \"" + preference.curve + "\" is " + shortNumber(preference.weight),
        "a number from 0");
    }
  }
  return {};
}
}
