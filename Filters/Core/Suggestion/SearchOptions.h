// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Flattening/FlatteningOptions.h"
#include "Surface/FeatureCurve.h"

#include <limits>
#include <string>
#include <vector>

namespace flattening
{
/// What may be proposed.
enum class SuggestedCuts
{
  Darts,
  Seams,
  All,
  Lines, ///< no cuts, but designLines()
};

/// What each cut is to lower.
enum class SearchGoal
{
  Energy, ///< the rigid energy
  Area,   ///< the mean change of area
  Strain  ///< the mean of the strain's fourth power, which tells of the largest
};

/// All lengths are in units of R = sqrt(area / pi) of the piece, except where said.
struct SearchOptions
{
  SuggestedCuts cuts = SuggestedCuts::All;
  SearchGoal goal = SearchGoal::Energy;
  /// The strain, on 95 % of each piece's area, that is good enough; 0: go on until cuts or length
  /// are used up, or no cut is worth its price.
  double bound = 0.02;
  Index maximumCuts = 8;
  /// Of all proposed cuts together, in the surface's unit.
  double maximumCutLength = std::numeric_limits<double>::infinity();
  /// Find a mirror plane and keep to it.
  bool symmetric = true;
  /// Curves along which a cut may begin or end at another price: it is divided by the weight; 0
  /// forbids it.
  struct Preference
  {
    std::string curve;
    double weight = 1.0;
  };
  std::vector<Preference> preferences;
  /// What each cut costs beside its length.
  double fixedPrice = 0.2;
  double leastLength = 0.12;
  /// Real flattenings to choose each cut from, after the forecast has ranked them.
  Index trials = 24;
  /// Of all real flattenings, in millions of steps of an iteration on one triangle, whatever the
  /// size of the surface. The best cuts that are found by then are proposed. 0: no limit.
  double maximumWork = 40.0;
};

/// Why a search ended.
enum class SearchEnd
{
  BoundMet,
  CutsUsedUp,
  NothingHelps, ///< no cut that the limits allow is worth its price
  GivenUp,      ///< the bound is out of reach, see searchCuts()
  WorkUsedUp,
  Interrupted ///< by the caller
};

/// Whether a proposed cut or line may have this name, such as "dart 3".
bool isProposedName(const std::string& name);

/// Errors: InvalidOption (a number out of its range, a preference for a curve that there is not, a
/// grain along curves of which there is none and that are not proposed either).
Status checkSearch(const SearchOptions& options, const FlatteningOptions& flattening,
  const std::vector<Polyline>& curves);
}
