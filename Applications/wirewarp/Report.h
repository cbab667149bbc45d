// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening.h"
#include "Options.h"

#include <string>

namespace wirewarp
{
/// The text of report.json. After a refusal `pieces` and `curves` are empty.
std::string makeReport(const Options& options, const Flattening& result);

/// Takes from report.json in the folder what the result was made of: surface, scheme, material and
/// grain where they are not given anew. Throws InputError where the folder holds no result.
void adoptReport(Options& options);

/// Reads flat pieces, wires, cut surface and, if there is one, sewn shape of a folder that
/// flattenToFiles() has written. Throws InputError.
Flattening readResult(const Options& options);
}
