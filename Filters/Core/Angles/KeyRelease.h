// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Surface/FeatureCurve.h"

#include <functional>
#include <optional>

namespace flattening
{
struct KeyRelease
{
  Indices released;    ///< keys, empty where no release helps
  Indices conflicting; ///< keys that cannot be kept together with others, those that were found
};

/// The objective without the planar shapes of these keys; none where there is no solution.
using ReleasedObjective = std::function<std::optional<double>(const Indices& released)>;

/// The least set of key curves whose release makes the others compatible, of several the one with
/// the least objective (of 32 that are compared). Where that takes more than 100 solutions, as it
/// does where many keys conflict with each other: a set of which no curve can be kept.
///
/// A conflict is a set of keys that cannot be kept together, though each smaller part of it can; a
/// set whose release helps has one key of each. So the search goes from one conflict to the next,
/// and does not depend on how many keys there are beside them.
/// \param keys ascending; that there is no solution with all of them is known
/// \param objective called once for each set
KeyRelease releaseKeys(const Indices& keys, const ReleasedObjective& objective);

/// IncompatibleKeys with the names of the key curves that conflict and of those that were released
/// (ids: curves).
Status describeRelease(
  const std::vector<FeatureCurve>& curves, const Indices& keys, const KeyRelease& release);
/// IncompatibleKeys where no release helps, with the names of all keys (ids: curves).
Status describeClash(const std::vector<FeatureCurve>& curves, const Indices& keys);
}
