// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"

namespace flattening
{
namespace pattern
{
/// Moves all of a piece so that the least coordinates of its lines are 0, and sets its extent.
void moveToOrigin(PatternPiece& piece);
}
}
