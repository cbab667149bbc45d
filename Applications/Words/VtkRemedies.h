// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RemedySpelling.h"

#include <vector>

class vtkFlatteningAlgorithm;
class vtkPatternWriter;

namespace wirewarp
{
/// The remedies that a filter or a writer found for its last run.
std::vector<Remedy> remediesOf(const vtkFlatteningAlgorithm* filter);
std::vector<Remedy> remediesOf(const vtkPatternWriter* writer);
}
