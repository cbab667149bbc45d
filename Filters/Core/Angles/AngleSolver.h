// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Angles/AngleSolution.h"
#include "Base/Execution.h"

namespace flattening
{
/// Solves Eq. 13 by the exact Newton method in the directions form, from the angles nearest to
/// alpha that meet all turning and 2 pi constraints.
AngleSolution solveAnglesByNewton(
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution);

/// Whether Newton's method should try from elsewhere: it has failed, or ended with an angle outside
/// (0, 2 pi) or far from alpha.
bool wantsAnotherStart(const AngleProblem& problem, const AngleSolution& solution);

/// Follows the minimum from the lengths of another start to the true ones.
/// \return the better one of that solution and the plain one, with the history of both
AngleSolution solveAnglesFrom(const AngleStart& start, AngleSolution plain,
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution);

/// The largest change of a free angle from its target, in radians; infinite where an angle has left
/// (0, 2 pi), except next to a dart's tip whose surface angle is there as well.
double largestAngleChange(const AngleProblem& problem, const std::vector<double>& theta);

/// A larger change than this is a poor solution: there may be a better minimum elsewhere, or there
/// are too many feature curves for the surface; in radians.
inline constexpr double poorAngleChange = 0.7;

/// Exact derivative of the optimal objective by the length of each wire edge,
/// dF* / dl = sum over both sides of lambda . (cos phi, sin phi).
std::vector<double> lengthSensitivity(const WireNetwork& network, const AngleSolution& solution);
}
