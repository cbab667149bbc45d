// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SystemCase.h"

#include <string>

namespace benchmarks
{
/// What a direct solver took for one system.
struct SolverTimes
{
  double analyze = 0.0; ///< seconds for the order of elimination and the structure of the factor
  double factor = 0.0;
  double solve = 0.0;
  double entries = 0.0;  ///< of the factor in CHOLMOD; 0 for the project's own
  double residual = 0.0; ///< largest |A x - b| over the largest |b|
};

/// Who finds the order of elimination.
enum class Ordering
{
  Own,           ///< the project's nested dissection, found beforehand
  MinimumDegree, ///< AMD
  Metis,
};

/// CHOLMOD's factor of a system: by dense blocks (supernodes, on BLAS) where it is definite, where
/// CHOLMOD knows no such factor, column by column otherwise. Throws std::runtime_error.
SolverTimes solveByCholmod(const SystemCase& system, Ordering ordering);

/// The project's own.
SolverTimes solveByOwn(const SystemCase& system, const flattening::Execution& execution);
}
