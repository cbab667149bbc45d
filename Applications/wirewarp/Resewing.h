// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/InputSurface.h"
#include "Options/OptionValues.h"

#include <string>

namespace CLI
{
class App;
}

namespace wirewarp
{
struct Flattening;
struct Options;

/// Adds the options of how flat pieces are sewn together again.
void addResewing(CLI::App& app, flattening::OptionValues& values);

/// Sews the flat pieces together again where the command is `sew`. What the cloth cannot do ends in
/// the result's status: a refusal leaves nothing of the flattening.
void sewAgain(const Options& options, Flattening& result);

/// A line a piece, or a line of all that is sewn together: how far it is from the surface; empty
/// where nothing was sewn.
std::string resewingTable(bool product, const Flattening& result);

/// Adds the options of how the surface is moved.
void addReshaping(CLI::App& app, flattening::OptionValues& values);

/// The body of a file; none of an empty name. Throws InputError.
flattening::LoadedBody loadedBody(const std::string& file);

/// How far the surface was moved for what; empty where it was not.
std::string reshapingTable(const Flattening& result);
}
