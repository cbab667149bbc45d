// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wirewarp
{
struct Options;

/// Reads and mends a surface and prints what it is: its size and the unit that fits it, parts,
/// openings, symmetry, and what stands in the way of flattening. Writes it where a file is named.
/// \return the exit code
int runCheck(const Options& options);
}
