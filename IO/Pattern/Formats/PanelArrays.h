// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Input/Columns.h"
#include "Outlines/PatternSource.h"

namespace flattening::pattern
{
/// Panels as arrays of the field data: `PanelNames`, `PanelLabels`, `PanelPlacements`,
/// `PanelEdges`, `PanelEdgeParameters`, `PanelEdgeLabels`, `PanelStitches`.
void writePanels(const PatternSource& source, Columns& fields);

/// The way back; nothing where the arrays are not there.
/// \return InvalidPattern where they do not fit each other or the pieces
Status readPanels(const Columns& fields, PatternSource& source);
}
