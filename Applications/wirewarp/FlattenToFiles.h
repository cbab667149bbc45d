// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening.h"
#include "Options.h"
#include "OutputFiles.h"

#include <string>
#include <vector>

namespace wirewarp
{
/// What became of one surface, and where it was written to.
struct FilesOfFlattening
{
  Flattening result;
  std::vector<std::string> files; ///< all that are written
};

/// Throws InputError where a file that flattenToFiles() may replace or remove is an input.
void refuseToReplaceInputs(const InputFiles& inputs, const Options& options);

/// Reads one surface, flattens it and writes all files that the options ask for. A refusal is in
/// the result, and in report.json where the folder exists already or was asked for. Throws
/// InputError where files cannot be written; earlier ones are left as they are then.
FilesOfFlattening flattenToFiles(const Options& given);
}
