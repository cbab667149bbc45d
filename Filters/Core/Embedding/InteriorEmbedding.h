// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Embedding/InteriorSystem.h"

namespace flattening
{
enum class InteriorMethod
{
  Laplacian,         ///< Eq. 11 solved directly
  Relaxation,        ///< Eq. 12: successive over-relaxation, by relaxInterior()
  AsRigidAsPossible, ///< as rigid as possible with the wires pinned
};

struct InteriorOptions
{
  InteriorMethod method = InteriorMethod::AsRigidAsPossible;
  /// Relaxation: factor tau of Eq. 12 (omega of SOR), between 0 and 2.
  double relaxation = 1.5;
  /// Relaxation: stop when no vertex moves farther than this fraction of the mean wire edge.
  double movement = 1e-5;
  int minimumIterations = 10;
  int maximumIterations = 100;
  /// As rigid as possible: stop when a Newton step lowers the energy by less than this fraction.
  double energyTolerance = 1e-9;
  int maximumRigidIterations = 200;
};

struct InteriorResult
{
  int iterations = 0; ///< the most that any wire-patch took
  Status status;
};

/// Places the vertices inside each wire-patch; those of the wires stay. Wire-patches are
/// independent and run in parallel. \param positions per piece vertex, in and out. \param kept
/// where to find and leave the systems for other runs of the same piece; null: their memory is
/// given back at once. \pre the method is not Relaxation.
///
/// Errors: InvalidOption; Cancelled (positions as they came in); NumericalFailure and NotConverged (ids:
/// wire-patches).
InteriorResult embedInterior(const Piece& piece, const WireNetwork& network,
  const InteriorOptions& options, const Execution& execution, Points2& positions,
  InteriorSystems* kept = nullptr);
}
