// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/SurfaceFlattening.h"
#include "TestMeshes.h"

namespace testmeshes
{
inline FlatteningOptions withScheme(Scheme scheme)
{
  FlatteningOptions options;
  options.scheme = scheme;
  return options;
}

/// Those of the paper's schemes, with pieces where they come to lie.
inline FlatteningOptions optionsOf(
  Scheme scheme, InteriorMethod interior = InteriorMethod::Laplacian)
{
  FlatteningOptions options = withScheme(scheme);
  options.interior.method = interior;
  options.arrange = false;
  return options;
}

inline FlatteningResult flatten(const Surface& surface, const FlatteningOptions& options = {},
  const Execution& execution = {}, FlatteningCache* cache = nullptr)
{
  return flattenSurface(surface.mesh, surface.curves, options, execution, cache);
}
}
