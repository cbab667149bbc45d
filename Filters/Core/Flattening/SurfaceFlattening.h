// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningCache.h"
#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"

namespace flattening
{
/// The whole way from a surface and its feature curves to flat pieces. \param cache of earlier
/// runs; null to keep nothing.
/// Errors: InvalidOption, and those of the stages.
FlatteningResult flattenSurface(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution, FlatteningCache* cache = nullptr);
}
