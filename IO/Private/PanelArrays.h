// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/PatternSource.h"

class vtkFieldData;

namespace flattening
{
namespace bridge
{
/// Panels as arrays of the field data: `PanelNames`, `PanelLabels`, `PanelPlacements`,
/// `PanelEdges`, `PanelEdgeParameters`, `PanelEdgeLabels`, `PanelStitches`.
void writePanels(const pattern::SourcePanels& panels, vtkFieldData* field);

/// The way back; nothing where the arrays are not there.
/// \return InvalidPattern where they do not fit each other or the pieces
Status readPanels(vtkFieldData* field, pattern::PatternSource& source);
}
}
