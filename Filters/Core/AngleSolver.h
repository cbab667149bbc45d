// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "AngleProblem.h"
#include "Execution.h"

namespace flattening
{
enum class AngleMethod
{
  Newton,     ///< the exact Newton method in the directions of the wire edges
  Sequential, ///< the paper's sequential linearly constrained programming, Eq. 15
};

struct AngleSolverOptions
{
  AngleMethod method = AngleMethod::Newton;
  int maximumIterations = 300;
  /// Largest closure of a loop at the end, as a fraction of the perimeter.
  double closureTolerance = 1e-12;
  /// Largest entry of the gradient of the Lagrangian at the end.
  double optimalityTolerance = 1e-10;
};

/// What one iteration did.
struct IterationRecord
{
  const char* phase = "";
  double objective = 0.0;
  double closure = 0.0;    ///< as a fraction of the perimeter
  double optimality = 0.0; ///< largest entry of the gradient of the Lagrangian
  double step = 0.0;       ///< root mean square of the change of the angles
};

struct AngleSolution
{
  std::vector<double> theta;         ///< planar angle per node
  std::vector<double> sideDirection; ///< phi per side, in the frame of its loop's multipliers
  std::vector<double> multiplierX;   ///< per loop, lambda_x of Eq. 14
  std::vector<double> multiplierY;   ///< per loop, lambda_y of Eq. 14
  std::vector<double> length;        ///< per wire edge, elastic ones with their stretch
  std::vector<double> stretch;       ///< h per stretch group
  double objective = 0.0;
  double closure = 0.0; ///< absolute, in the unit of length
  int iterations = 0;
  std::vector<IterationRecord> history;
  /// Ok, NotConverged (theta is the best found), IncompatibleKeys (ids: nodes), Cancelled.
  Status status;
};

/// Solves Eq. 13. Sequential starts from theta = alpha as the paper does. Newton starts from the
/// angles nearest to alpha that meet all turning and 2 pi constraints; where that fails or ends
/// with an angle outside (0, 2 pi) or far from alpha, it also follows the problem's alternative
/// start to the true lengths, and the better minimum is returned. Problems with stretch groups are
/// solved by Newton.
AngleSolution solveAngles(
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
