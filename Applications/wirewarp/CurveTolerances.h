// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>

#include <map>
#include <string>
#include <vector>

namespace wirewarp
{
/// Length tolerances by curve name, from `--tolerance NAME=FRACTION`.
using CurveTolerances = std::map<std::string, double>;

/// Writes the tolerances into the cell array `LengthTolerance` of the data that hold the named
/// curves; curves that are not named keep theirs. Throws InputError where no curve has a name.
void applyTolerances(const CurveTolerances& tolerances, const std::vector<vtkPolyData*>& curves);
}
