// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

namespace wirewarp
{
/// Explains files, units and exit codes.
void printFormats(std::ostream& out);
}
