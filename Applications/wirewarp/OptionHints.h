// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace wirewarp
{
/// "; is --scheme meant?" for the first of the arguments that no option took and that is nearly the
/// name of one, by Levenshtein's distance; empty where none is.
std::string nearestOption(const CLI::App& app, const std::vector<std::string>& unknown);
}
