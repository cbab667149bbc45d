// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/PatternSource.h"

namespace flattening
{
namespace pattern
{
/// Errors: InvalidOption where a value is out of range, or a curve is named that is not there.
Status checkPatternOptions(const PatternSource& source, const PatternOptions& options);
}
}
