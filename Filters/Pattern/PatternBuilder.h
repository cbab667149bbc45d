// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Pattern.h"
#include "PatternSource.h"

namespace flattening
{
namespace pattern
{
/// Draws a flattening as a pattern to cut at true scale. The lines that are wires have their points
/// exactly where the flattening has them, scaled to millimetres and moved.
Status buildPattern(const PatternSource& source, const PatternOptions& options, Pattern& pattern);
}
}
