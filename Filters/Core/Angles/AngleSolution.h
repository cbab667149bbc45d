// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

#include <vector>

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
  AngleMethod method = AngleMethod::Newton; ///< that solved it
  std::vector<IterationRecord> history;
  /// Ok, NotConverged (theta is the best found), IncompatibleKeys (ids: nodes), Cancelled.
  Status status;
};
}
