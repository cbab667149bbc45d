// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options.h"

#include <string>
#include <vector>

namespace wirewarp
{
/// One surface of a list and the folder of its files.
struct BatchEntry
{
  std::string surface;
  std::vector<std::string> curves;
  std::string folder; ///< in the output folder: the surface's name, numbered where it comes again
};

/// Reads a list of surfaces, one a line with its files of curves: words divided by blanks, in
/// double quotes where a name holds blanks; '#' starts a comment. Throws InputError.
std::vector<BatchEntry> readBatch(const std::string& path);

/// Flattens all surfaces of the list, each into a folder of its own and as many at a time as there
/// are threads, and writes batch.json. A surface that is refused does not stop the others. \return
/// the exit code: that of the worst.
int runBatch(const Options& options);
}
