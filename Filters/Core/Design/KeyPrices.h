// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Flattening/FlatteningOptions.h"
#include "Surface/FeatureCurve.h"
#include "Surface/TriangleMesh.h"

#include <limits>
#include <string>
#include <vector>

namespace flattening
{
/// A flattening with some of the key curves; measures are those of the piece where they are
/// largest.
struct KeyTrial
{
  /// Of the first piece that breaks a promise, or of the refusal.
  StatusCode status = StatusCode::Ok;
  /// Not a number where the surface was refused.
  double areaError = std::numeric_limits<double>::quiet_NaN();
  double strainP95 = std::numeric_limits<double>::quiet_NaN();
  Indices released; ///< keys that lost their shape, since they clash with others
};

/// What the planar shape of one key curve costs.
struct KeyPrice
{
  Index curve = none;
  /// By how much areaError falls where its shape alone is given up.
  double price = 0.0;
  KeyTrial without; ///< with all other keys
  KeyTrial alone;   ///< with no other key
};

struct KeyPrices
{
  Status status; ///< InvalidCurve: there is no key curve; Cancelled; or the refusal with all keys
  KeyTrial all;
  KeyTrial none;
  /// The dearest first: by the number of keys that are given up without it, then by price.
  std::vector<KeyPrice> keys;
};

/// Flattens a surface without each of its key curves, and with each alone. A key that is left out
/// keeps its lengths and is free in its shape. Where keys contradict each other, the flattening
/// without one that is to blame gives up no other. The same for any number of threads.
KeyPrices priceKeys(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution = {});
}
