// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wirewarp
{
struct Options;

/// Sorts what --output names by the command: files by their endings, and the folder that keeps the
/// result; or takes the command's default. Throws InputError for a file that the command does not
/// write.
void resolveOutputs(Options& options);
}
