// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/SearchedPiece.h"
#include "Suggestion/SuggestedCurve.h"

#include <optional>

namespace flattening
{
/// A cut as a plan on a piece, from which it can be moved; nothing where it cannot be there.
/// \param paired with its image on the same piece \param near up to this far from the boundary, in
/// the surface's unit, its ends lie on it
std::optional<CutPlan> plannedCut(
  const SearchedPiece& piece, const SuggestedCurve& cut, bool paired, double near);
}
