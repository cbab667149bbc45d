// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening.h"
#include "Options.h"

namespace wirewarp
{
/// Flattens the other sizes and lays them on the base, whose flattening this is. Where one is
/// refused, so is the result, with the size in its message.
void gradeSizes(const Options& options, Flattening& result);
}
