// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Cut/SurfaceCut.h"
#include "Suggestion/CurveSuggestions.h"

namespace flattening
{
/// Lines that a designer draws on a surface, as sections with planes, piece by piece, from edge to
/// edge or closed:
///
/// - "centre line", a straight key curve: the section with a piece's own mirror plane;
/// - "grain line", a straight key curve, for pieces without one: through the centre of area, along
///   the piece's longest axis and across its mean normal;
/// - "girth", accessory curves: across the longest axis of the whole surface (in its mirror plane,
///   where it has one; x, y or z where it is within 20 degrees of that), where its sections are
///   longer or shorter than all near them, as at bust, waist and hip; the three that stand out
///   most;
/// - "style line", accessory curves: beside the centre or grain line, where a piece is farthest
///   from lying flat (by ScaleFactor), as a princess line goes over the bust.
///
/// Pieces with a key curve get no centre or grain line. Where a plane comes within 20 degrees of
/// touching the surface no line is drawn.
std::vector<SuggestedCurve> designLines(const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, bool symmetric, const Execution& execution = {});
}
