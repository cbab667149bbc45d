// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleSolution.h"
#include "Angles/AngleSolverOptions.h"
#include "Angles/DirectionsForm.h"
#include "Base/Ending.h"
#include "Base/Execution.h"
#include "Sparse/NewtonKkt.h"

namespace flattening
{
/// Exact Newton method on the directions form.
/// \param phase name in the records, which are appended to history.
NewtonKktState solveAnglesByNewton(const DirectionsForm& form, NewtonKktState start,
  const AngleSolverOptions& options, const Execution& execution, const char* phase,
  std::vector<IterationRecord>& history);
}
