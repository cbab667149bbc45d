// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <ostream>

namespace wirewarp
{
/// Explains files, units and exit codes.
void printFormats(std::ostream& out);

/// The materials that --material knows by name: a table, then the sources of the numbers.
void printMaterials(std::ostream& out);
}
