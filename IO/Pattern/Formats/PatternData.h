// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Formats/PatternFile.h"
#include "Input/DataSet.h"
#include "Outlines/PatternSource.h"

#include <string>

namespace flattening::pattern
{
/// Reads the outputs of vtkWireWarpingFilter.
/// \param wires, cut may be null
Status readPattern(
  const DataSet& flat, const DataSet* wires, const DataSet* cut, PatternSource& source);

/// Draws a flattening and writes the file, with the day and minute in UTC. SOURCE_DATE_EPOCH makes
/// files that can be made again bit for bit.
Status writePattern(const std::string& path, const PatternSource& source,
  const FileOptions& options, Pattern& drawing);
}
