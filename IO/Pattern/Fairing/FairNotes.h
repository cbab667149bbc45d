// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairBorders.h"
#include "Outlines/Pattern.h"

namespace flattening
{
namespace pattern
{
/// Says on a piece what was drawn smoothly, what was made straight or its own mirror image, and
/// what was left as it was and why.
void addFairNotes(const FairPieceReport& report, PatternPiece& piece);
}
}
