// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Garment.h"
#include "Outlines/PatternSource.h"

namespace flattening::pattern
{
/// The panels as flat pieces, triangles on the points of their borders, in centimetres: curved
/// edges as chords within sampleDistance of them, the same number on both edges of a stitch. What
/// is sewn together edge by edge under one label is one seam, or a dart where it ends in a common
/// point. Panels whose borders run clockwise stay as they are, with their triangles
/// counter-clockwise.
/// \return InvalidPattern where checkGarment() does, and where a border crosses itself
Status makePieces(const Garment& garment, PatternSource& source);
}
