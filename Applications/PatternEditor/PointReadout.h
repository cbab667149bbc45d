// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pieces.h"

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>

#include <string>

namespace editor
{
/// What the flat piece has to say at the mouse: its measures and, on a material, what its threads
/// do there.
class PointReadout
{
public:
  /// \param flat null: there is none
  void setPiece(const figures::FlatPiece& piece);

  /// At a pixel of the view of the plane; empty beside the pieces.
  std::string at(vtkRenderer* plane, int x, int y);

private:
  vtkIdType cellAt(vtkRenderer* plane, int x, int y);

  figures::FlatPiece Piece;
  vtkSmartPointer<vtkStaticCellLocator> Locator; ///< made when somebody asks
};
}
