// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wirewarp
{
struct Options;

/// Flattens all surfaces of the list, each into a folder of its own and as many at a time as there
/// are threads, and writes batch.json. A surface that is refused does not stop the others. \return
/// the exit code: that of the worst.
int runBatch(const Options& options);
}
