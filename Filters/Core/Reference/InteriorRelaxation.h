// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Embedding/InteriorEmbedding.h"

namespace flattening
{
/// Places the vertices inside each wire-patch by Eq. 12, successive over-relaxation of Eq. 11:
/// sweeps in place in the order of the vertices, from the center of the patch's wires.
/// Wire-patches run in parallel. \param positions per piece vertex, in and out.
///
/// Errors: InvalidOption; Cancelled (positions as they came in); NotConverged (ids: wire-patches).
InteriorResult relaxInterior(const Piece& piece, const WireNetwork& network,
  const InteriorOptions& options, const Execution& execution, Points2& positions);

/// Places them by the method of the options: relaxInterior() or embedInterior().
InteriorResult placeInterior(const Piece& piece, const WireNetwork& network,
  const InteriorOptions& options, const Execution& execution, Points2& positions,
  InteriorSystems* kept = nullptr);
}
