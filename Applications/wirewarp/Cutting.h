// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace wirewarp
{
struct Options;

/// A fraction as 0.02 or 2%.
CLI::Validator percentage(double least, double most, const std::string& range);

/// Adds the options of how cuts are proposed.
void addCutting(CLI::App& app, Options& options);
}
