// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutSetSearch.h"

namespace flattening
{
/// What a share of strain above the bound weighs against one of the price; within it they weigh
/// alike.
constexpr double unmetWeight = 10.0;

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
  /// bound by distortionOf(). \param worth by how much a set must be better
  double merit(const CutSet& set, double worth) const;
  /// What is less may become better by adjustCuts(). For a bound the price, times what the strain
  /// is above the bound to some power: unmetWeight, as cuts are adjusted; 1 for sets that are cheap
  /// and far from it, since strain goes with the inverse of the length that cuts may have. Without
  /// one distortionOf(), which goes with the square of that.
  double promise(const CutSet& set, double worth, double power) const;

private:
  double price(const CutSet& set) const;

  const SearchOptions& Search;
  double Size; ///< sqrt(area / pi)
};
}
