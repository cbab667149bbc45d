// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening.h"
#include "Options.h"

#include <string>

namespace wirewarp
{
/// The text of report.json. After a refusal `pieces` and `curves` are empty.
std::string makeReport(const Options& options, const Flattening& result);

/// Fills the tables of pieces and curves, and the times, from the text of report.json, without
/// lists of iterations and releases. Throws an exception of nlohmann::json where it is another
/// text.
void takeReport(const std::string& text, Flattening& result);
}
