// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/PatternSource.h"

namespace flattening::pattern
{
/// The same flattening with cuts that were closed (SewnEdges::closed) taken for whole cloth: the
/// points of their two banks become one, they are sewn nowhere, and of their wires what is still
/// open is left.
PatternSource withoutClosedCuts(const PatternSource& source);
}
