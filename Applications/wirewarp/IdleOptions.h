// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options.h"

#include <functional>
#include <string>

namespace wirewarp
{
/// Whether an option stands on the command line.
using IsGiven = std::function<bool(const std::string&)>;

/// What is wrong with the first option that is given although the method that the others choose has
/// no use for it; empty: nothing.
std::string idleOption(const Options& options, const IsGiven& isGiven);
}
