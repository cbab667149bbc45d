// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/SurfaceFlattening.h"
#include "WiredSurface.h"

#include <stdexcept>

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

/// A free boundary with the energy that is chosen by default for it.
inline FlatteningOptions freeBoundary()
{
  FlatteningOptions options;
  options.boundary = BoundaryMode::Free;
  options.isometric.energy.kind = DistortionEnergyKind::Automatic;
  return options;
}

inline FlatteningResult flatten(const Surface& surface, const FlatteningOptions& options = {},
  const Execution& execution = {}, FlatteningCache* cache = nullptr)
{
  return flattenSurface(surface.mesh, surface.curves, options, execution, cache);
}

/// Expects neither an error nor a warning.
inline FlatteningResult flattenOk(const Surface& surface, const FlatteningOptions& options = {})
{
  FlatteningResult result = flatten(surface, options);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  if (result.status.refused())
  {
    throw std::runtime_error("there is no result");
  }
  return result;
}

/// Of the edges of wires, connectors left out.
inline double worstLength(const FlatteningResult& result)
{
  double worst = 0.0;
  for (const Wire& wire : result.wires)
  {
    worst = std::max(worst, wire.connector ? 0.0 : wire.maximumEdgeError);
  }
  return worst;
}

/// Largest distance of a piece's flat vertices from the unrolling, each piece moved on its own.
inline double worstPiece(const Surface& surface, const FlatteningResult& result)
{
  double worst = 0.0;
  for (const Piece& piece : extractPieces(*result.cut))
  {
    Points2 flat;
    Points2 unrolled;
    for (const Index v : piece.vertices)
    {
      flat.push_back(result.positions[v]);
      unrolled.push_back(surface.unrolled[result.cut->originalVertex[v]]);
    }
    worst = std::max(worst, rigidDistance(flat, unrolled));
  }
  return worst;
}
}
