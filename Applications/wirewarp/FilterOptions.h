// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options.h"

#include <vtkSmartPointer.h>

class vtkWireWarpingFilter;

namespace wirewarp
{
/// What the filter is told where the command line says nothing: its own defaults.
Options defaultOptions();

/// The filter that flattens, which proposes curves first where that is asked for.
vtkSmartPointer<vtkWireWarpingFilter> makeFilter(const Options& options);

/// Tells the filter all but its input and the tolerances of curves.
void setOptions(const Options& options, vtkWireWarpingFilter* filter);
}
