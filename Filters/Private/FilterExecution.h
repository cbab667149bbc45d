// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"

class vtkAlgorithm;

namespace flattening::bridge
{
/// Progress to UpdateProgress with the phase as its text, also each 50 ms in between so that an
/// observer can end the run; cancel from the abort flag, loops by vtkSMPTools.
Execution executionOf(vtkAlgorithm* algorithm);
}
