// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options.h"

#include <optional>

namespace wirewarp
{
/// Reads the command line. No value: everything is said already, and `exitCode` is what to return.
std::optional<Options> parseCommandLine(int argc, char** argv, int& exitCode);
}
