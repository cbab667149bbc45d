// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CurveSuggestions.h"
#include "Suggestion/CutTrials.h"
#include "Suggestion/SurfaceMirror.h"

#include <optional>
#include <vector>

namespace flattening
{
/// The width of the widest flat piece, each measured where it is least: the distance of the nearest
/// two parallel lines that a piece lies between; the one allowed where it is greater by rounding.
double greatestWidth(const CutTrials::Trial& flat, double allowed);

/// Adds seams, straight in the plane, that part pieces wider than cloth into strips of equal
/// widths. Pieces that are mirror images are parted alike. \param size of the surface, sqrt(area /
/// pi)
void addStripSeams(const CutTrials::Trial& flat, double maximumWidth,
  const std::optional<SurfaceMirror>& mirror, double size, std::vector<SuggestedCurve>& cuts);
}
