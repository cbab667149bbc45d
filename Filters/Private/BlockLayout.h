// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class vtkDataObject;
class vtkMultiProcessController;

namespace flattening
{
namespace bridge
{
/// Moves flat surfaces, those of all blocks and processes in rows, to the right of the surfaces in
/// space that they are of, at half their height. Their points are moved in place, and with them
/// those of the wires, which share them. Where there are several processes, all must call it.
/// \param spacing as in arrangePieces().
void layBeside(vtkDataObject* surfaces, vtkDataObject* flat, double spacing,
  vtkMultiProcessController* processes);
}
}
