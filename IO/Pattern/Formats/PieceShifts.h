// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/PdfPages.h"

namespace flattening
{
namespace pattern
{
/// Moves pieces within the free space around them, as far apart as they were laid at least, where
/// fewer pages then show something. Neither pieces laid on cloth nor the sheet change.
void saveByShifts(const Pattern& pattern, PagePlan& plan);
}
}
