// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/OptionTable.h"

#include <vtkSmartPointer.h>

#include <string>

namespace CLI
{
class App;
}

class vtkFlatPieceAlgorithm;

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

struct Flattening;

/// Adds the options of how the surface is moved.
void addReshaping(CLI::App& app, flattening::OptionValues& values);

/// The filter that moves the surface before it flattens it.
vtkSmartPointer<vtkFlatPieceAlgorithm> makeReshapingFilter(const flattening::OptionValues& values);

/// Gives it the body of this file, where it is one that moves the surface. Throws InputError.
void setBody(const std::string& body, vtkFlatPieceAlgorithm* filter);

/// Takes over what the filter has beside the flattening, where it is one that moves the surface.
void takeReshaped(vtkFlatPieceAlgorithm* filter, Flattening& result);

/// How far the surface was moved for what; empty where it was not.
std::string reshapingTable(const Flattening& result);
}
