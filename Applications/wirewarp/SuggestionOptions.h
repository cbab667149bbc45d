// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI
{
class App;
}

namespace wirewarp
{
struct Options;

/// Adds --suggest and what it needs.
void addSuggestionOptions(CLI::App& app, Options& options);

/// Adds --price-keys, after the options that it excludes.
void addKeyPriceOptions(CLI::App& app, Options& options);
}
