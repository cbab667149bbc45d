// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening.h"
#include "Options.h"

#include <string>

namespace wirewarp
{
/// The text of report.json. After a refusal `pieces` and `curves` are empty.
std::string makeReport(const Options& options, const Flattening& result);

/// "accessory", "key", "dart" or "seam".
std::string curveTypeName(long long type);
}
