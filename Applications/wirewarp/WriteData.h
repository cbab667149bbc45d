// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Input/DataSet.h"

#include <string>
#include <vector>

namespace wirewarp
{
/// Of the files that keep a result, with its dot: .vtp, and .obj in builds without VTK.
extern const char* const dataExtension;

/// "VTK 9.1.0", or "without VTK".
std::string vtkInWords();

struct NamedData
{
  std::string file;
  const flattening::DataSet* data = nullptr;
};

/// The bytes of each file. Throws InputError where this build does not write its format.
std::vector<std::string> bytesOf(
  const std::vector<NamedData>& files, const flattening::Execution& execution);

/// Wavefront OBJ: points, faces, and lines in groups with their types and names.
std::string objOf(const flattening::DataSet& data);
}
