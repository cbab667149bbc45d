// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedSurface.h"

#include <map>
#include <string>

namespace flattening
{
namespace bridge
{
/// The refusal of a name that no curve has.
Status noCurveNamed(const std::string& name, const CurvedSurface& source);

/// Gives the curves of each name their length tolerance. InvalidOption where no curve has the name,
/// or the tolerance lies outside [0, 1).
Status applyTolerances(const std::map<std::string, double>& tolerances, CurvedSurface& source);
}
}
