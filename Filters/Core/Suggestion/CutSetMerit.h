// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutSetSearch.h"

namespace flattening
{
/// What is to be low where there is no bound: the mean of the rigid energy and, counted twice, the
/// square of the mean change of area, as a product.
double distortionOf(const TrialOutcome& outcome);

/// Compares sets of cuts that were found for one surface. What is less is better.
class CutSetMerit
{
public:
  /// The options must outlive it. \param area of the surface
  CutSetMerit(const SearchOptions& search, double area);

  bool withinBound(double strain) const
  {
    return this->Search.bound > 0.0 && strain <= this->Search.bound;
  }
  /// Sets that meet the bound by their price, before those that do not by their strain; without a
  /// bound by distortionOf().
  double merit(const CutSet& set) const;

private:
  double price(const CutSet& set) const;

  const SearchOptions& Search;
  double Size; ///< sqrt(area / pi)
};
}
