// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleSolver.h"

namespace flattening
{
/// A piece whose homogeneity of distortion falls below this lies poorly: areas are changed by more
/// than 2.5 against each other. Pieces as they are cut in practice stay above 0.48; below are those
/// on which the curves have no good exact solution together.
inline constexpr double poorHomogeneity = 0.4;

/// Whether a triangle is flipped or the homogeneity (E_h) is poor.
bool liesPoorly(const TriangleMesh& mesh, const Points2& positions);

/// Which feature curves keep a piece from a better solution.
struct ReleaseAdvice
{
  /// Per feature curve dF* / d ln(length): how the optimum of Eq. 13 changes when all edges of the
  /// curve grow in proportion. 0 for curves that have no edge inside the piece.
  std::vector<double> sensitivity;
  /// Curves with an edge inside the piece, and, where releases were tried, key curves with one on
  /// its boundary: tried ones first, the least optimum first; then by the magnitude of their
  /// sensitivity; ties by the smaller id.
  Indices ranking;
  /// Per curve of the ranking the optimum without it, of a key curve without its shape; -1 where
  /// that was not tried or has no solution.
  std::vector<double> objectiveWithout;

  double objectiveWithoutFirst() const
  {
    return this->objectiveWithout.empty() ? -1.0 : this->objectiveWithout.front();
  }
};

/// \param poor try the release of the three curves whose lengths and the three keys whose shapes cost
/// most
ReleaseAdvice adviseRelease(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const AngleSolution& solution,
  const AngleSolverOptions& options, bool poor, const Execution& execution);
}
