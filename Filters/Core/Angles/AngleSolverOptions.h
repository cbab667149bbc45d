// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
}
