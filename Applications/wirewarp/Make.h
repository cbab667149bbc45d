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
struct FilesOfFlattening;
struct Options;

/// Adds --for, which names what is made.
void addMaking(CLI::App& app, Options& options);

/// Throws CLI::ValidationError where a template needs an option that is not given.
void checkTemplate(const Options& options);

/// Arguments of `wirewarp make` with the options of what is made behind them, but for those that
/// are given.
std::vector<std::string> withOptionsOfKind(std::vector<std::string> arguments);

/// What was made in five lines: surface, cuts, pieces, fit, and the files to open.
std::string summaryOfMaking(const Options& options, const FilesOfFlattening& written);
}
