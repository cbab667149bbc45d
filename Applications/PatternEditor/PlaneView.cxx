// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneView.h"

#include "Drawing.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <algorithm>

namespace editor
{
void PlaneView::show(const figures::FlatPiece& piece, figures::Coloring coloring)
{
  vtkNew<vtkCamera> before;
  before->DeepCopy(this->Renderer->GetActiveCamera());
  figures::Drawing drawing(this->Renderer);
  const figures::ColorMap map = figures::makeColorMap(coloring, piece.flat);
  drawing.addMap(piece.flat, map.array, map.onPoints, map.colors);
  drawing.addWires(piece.wires, figures::DartSides::Blue);
  const int* const window = this->Renderer->GetRenderWindow()->GetSize();
  const std::array<int, 2> pixels{ std::max(window[0], 100), std::max(window[1], 100) };
  const std::array<double, 2> size = drawing.size();
  const double pixel = std::max(size[0] / (0.9 * pixels[0]), size[1] / (0.9 * pixels[1]));
  drawing.finish({ 0, 0, pixels[0], pixels[1] }, pixel, {});
  if (this->CameraSet)
  {
    this->Renderer->GetActiveCamera()->DeepCopy(before);
    this->Renderer->ResetCameraClippingRange();
  }
  this->CameraSet = true;
}

//------------------------------------------------------------------------------
void PlaneView::clear()
{
  this->Renderer->RemoveAllViewProps();
  this->CameraSet = false;
}
}
