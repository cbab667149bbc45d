// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutSetMerit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// What keeps sets that do not meet the bound behind those that do, and those that cannot be
/// flattened behind both.
constexpr double unmet = 1e6;
constexpr double useless = 1e12;
}

double distortionOf(const TrialOutcome& outcome)
{
  return std::cbrt(outcome.energy * std::pow(outcome.areaError, 4.0));
}

CutSetMerit::CutSetMerit(const SearchOptions& search, double area)
  : Search(search)
  , Size(std::sqrt(area / pi))
{
}

double CutSetMerit::merit(const CutSet& set) const
{
  if (!set.outcome.valid)
  {
    return useless;
  }
  if (this->Search.bound == 0.0)
  {
    return distortionOf(set.outcome);
  }
  return this->withinBound(set.outcome.strainP95) ? this->price(set)
                                                  : unmet * (1.0 + set.outcome.strainP95);
}

double CutSetMerit::price(const CutSet& set) const
{
  double price = 0.0;
  for (const SuggestedCurve& cut : set.cuts)
  {
    price += this->Search.fixedPrice + cut.length / this->Size;
  }
  return price;
}
}
