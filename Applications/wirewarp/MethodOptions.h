// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options.h"

#include <vtkFlatPieceAlgorithm.h>
#include <vtkSmartPointer.h>

namespace CLI
{
class App;
}

namespace wirewarp
{
/// Adds the options of how surfaces are flattened.
void addMethods(CLI::App& app, Options& options);

/// The filter that does what the options say, without their values.
vtkSmartPointer<vtkFlatPieceAlgorithm> makeFilter(const Options& options);

void setOptions(const Options& options, vtkFlatPieceAlgorithm* filter);

/// Adds the options of how cuts are proposed.
void addCutting(CLI::App& app, Options& options);
}
