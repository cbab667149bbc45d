// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HostileCase.h"

namespace hostile
{
/// The pieces of Data/ with all their curve sets; a piece with several sets comes once for each.
/// Empty where the folder cannot be read.
const std::vector<Specimen>& dataSpecimens();
}
