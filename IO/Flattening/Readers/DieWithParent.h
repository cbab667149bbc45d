// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wirewarp
{
/// Ends the calling process, a child, as soon as its parent has ended, even by SIGKILL. Where the
/// system knows no such thing, it ends when it next reads from or writes to its parent.
/// \param parent its id, taken before the fork
void dieWithParent(int parent);
}
