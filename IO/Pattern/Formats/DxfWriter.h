// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"

namespace flattening::pattern
{
/// A pattern as DXF R12 ASCII after ASTM D6673 / AAMA: one block and one insert a piece, numbered
/// layers (1 boundary and system texts, 2 turn points and numbers of grade rules, 3 curve points, 4
/// notches, 7 grainline, 8 internal lines, 11 cutouts, 13 drill holes, 14 sew lines, 15
/// annotation). Beside the points that pattern systems look for, notches are short lines and drill
/// holes circles, for who else opens the file. Blocks bear the names of the pieces; layers and
/// entities have handles. Coordinates are millimetres with the text "Units: METRIC", or, where the
/// surface was in inches, inches with "Units: ENGLISH".
std::string makeDxf(const Pattern& pattern);

/// The same for laser, knife and router: model space alone, with the layers CUT, MARK and TEXT,
/// each line once as a polyline with arcs, nothing that a machine would cut twice, no points, and
/// no grainline on sheets.
std::string makeCutterDxf(const Pattern& pattern);
}
