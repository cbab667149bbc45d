// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"

#include <vector>

namespace flattening
{
/// A piece of which more than this share of the area is beyond its material's limits misses them;
/// less is left to corners, where exact lengths decide.
constexpr double toleratedShareOutOfLimit = 0.05;

/// What the cloth of the options promised the last piece of a result and did not keep, the worst
/// first: MissingGrain, BeyondLimits
/// (ids: triangles, the one farthest out first).
std::vector<Status> brokenClothPromises(const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const FlatteningResult& result);
}
