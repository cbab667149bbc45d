// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "AngleSolver.h"

namespace flattening
{
/// Which feature curves keep a piece from a better solution.
struct ReleaseAdvice
{
  /// Per feature curve dF* / d ln(length): how the optimum of Eq. 13 changes when all edges of the
  /// curve grow in proportion. 0 for curves that have no edge inside the piece.
  std::vector<double> sensitivity;
  /// Curves with an edge inside the piece, the largest magnitude first; ties by the smaller id.
  Indices ranking;
  /// The optimum without the first curve of the ranking; only where it was asked for and found.
  double objectiveWithoutFirst = -1.0;
};

/// \param tryFirst also solve without the first curve.
ReleaseAdvice adviseRelease(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const AngleSolution& solution,
  const AngleSolverOptions& options, bool tryFirst, const Execution& execution);
}
