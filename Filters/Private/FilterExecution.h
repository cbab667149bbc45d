// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Execution.h"

class vtkAlgorithm;

namespace flattening
{
namespace bridge
{
/// Progress to UpdateProgress with the phase as its text, cancel from the abort flag, loops by
/// vtkSMPTools.
Execution executionOf(vtkAlgorithm* algorithm);
}
}
