// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/SearchedPiece.h"

namespace flattening
{
/// The first of the plans that differ: of those that lie close to each other the one that comes
/// first.
std::vector<CutPlan> distinctPlans(
  const SearchedPiece& piece, const std::vector<CutPlan>& plans, Index most);
}
