// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/PieceSolution.h"

namespace flattening
{
/// Solves the planar angles of a piece's wires by the scheme of the options, patch by patch or all
/// together, from a conformal map where the plain start ends badly. Shapes of key curves that fold
/// a wire over are IncompatibleKeys.
PieceSolution solveWires(const PieceContext& context, const CurveRules& rules);

/// The same where the shapes of key curves may contradict each other: then without the least set of
/// keys with which they do not (see releaseKeys()).
PieceSolution solveWithKeys(const PieceContext& context, const CurveRules& rules);

/// Positions from the wires' angles: the layout of the wires, the interior between them, untangled
/// where that is as rigid as possible. Nothing where the piece is placed or its wires have no
/// angles.
void placeWires(const PieceContext& context, PieceSolution& solution);

/// Where the shapes of key curves can be met, but only by wires that fold triangles over: solved
/// and placed without the least set of keys with which none folds. No value where no release helps,
/// or nothing is locked that could be released.
std::optional<PieceSolution> releaseFoldingKeys(
  const PieceContext& context, const PieceSolution& folded);

/// Largest relative error, beyond rounding, of a wire edge against the lengths solved for. \param
/// all whether those count that are not held
double largestLengthError(const AngleProblem& problem, const std::vector<double>& lengths,
  const Points2& positions, bool all);
}
