// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"

namespace flattening::pattern
{
/// A pattern as DXF R12 ASCII after ASTM D6673 / AAMA, with the layers and units that
/// vtkPatternWriter documents, and the numbers of grade rules on layer 2. Beside the points that
/// pattern systems look for, notches are short lines and drill holes circles, for who else opens
/// the file. Layers and entities have handles.
std::string makeDxf(const Pattern& pattern);

/// The same for laser, knife and router: model space alone, with the layers CUT, MARK and TEXT,
/// each line once as a polyline with arcs, nothing that a machine would cut twice, no points, and
/// no grainline on sheets.
std::string makeCutterDxf(const Pattern& pattern);
}
