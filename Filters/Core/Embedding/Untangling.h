// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Wires/WireNetwork.h"

namespace flattening
{
struct UntanglingOptions
{
  /// Iterations in a row that may leave no fold less before a patch is given up: where wires leave
  /// it no way to lie flat, epsilon falls for ever.
  int patience = 200;
  /// Whether only what lies around the flipped triangles is moved: quicker where they are few, and
  /// the rest stays as good as it is.
  bool nearby = false;
};

struct UntanglingResult
{
  Indices patches; ///< wire-patches that had a flipped triangle and were worked on
  Indices tangled; ///< those of them that still have one
  Status status;   ///< Ok or Cancelled
};

/// Turns flipped triangles inside wire-patches the right way up, with all wires pinned.
///
/// Per wire-patch with a triangle of det J <= 0, minimizes a barrier energy whose barrier is
/// regularized by epsilon, and lowers epsilon until no triangle is flipped (V. Garanzha, I.
/// Kaporin, L. Kudryavtseva, F. Protais, N. Ray, D. Sokolov, "Foldover-free maps in 50 lines of
/// code", ACM Transactions on Graphics 40(4), 2021), by projected Newton steps. A patch whose
/// planar loop crosses itself, or a triangle between wires only, cannot be helped; what is best is
/// kept. Patches are worked on in parallel.
/// \param positions per piece vertex, in and out.
UntanglingResult untangleInterior(const Piece& piece, const WireNetwork& network,
  const Execution& execution, Points2& positions, const UntanglingOptions& options = {});
}
