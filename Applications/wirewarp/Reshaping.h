// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/OptionTable.h"

#include <vtkSmartPointer.h>

#include <string>

class vtkFlatPieceAlgorithm;

namespace CLI
{
class App;
}

namespace wirewarp
{
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
