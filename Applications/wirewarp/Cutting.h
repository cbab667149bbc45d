// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI
{
class App;
}

namespace wirewarp
{
struct Options;

/// Adds the options of how cuts are proposed.
void addCutting(CLI::App& app, Options& options);
}
