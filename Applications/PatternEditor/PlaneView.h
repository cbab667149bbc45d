// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Coloring.h"

#include <vtkRenderer.h>

namespace editor
{
/// The flat pieces with their wires.
class PlaneView
{
public:
  explicit PlaneView(vtkRenderer* renderer)
    : Renderer(renderer)
  {
  }

  /// The camera stays as the user has it, but for the first pieces and after reset().
  void show(const figures::FlatPiece& piece, figures::Coloring coloring);
  void clear();
  void reset() { this->CameraSet = false; }

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  bool CameraSet = false;
};
}
