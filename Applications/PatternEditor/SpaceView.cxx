// SPDX-License-Identifier: BSD-3-Clause
#include "SpaceView.h"

#include "Drawing.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkMath.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace editor
{
namespace
{
constexpr std::array<unsigned char, 4> strongGhost{ 255, 90, 0, 255 };
constexpr std::array<unsigned char, 4> paleGhost{ 255, 150, 60, 130 };
constexpr double surfaceMargin = 1.08;
}

SpaceView::SpaceView(vtkRenderer* renderer)
  : Renderer(renderer)
{
  renderer->SetBackground(1.0, 1.0, 1.0);
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->SetColor(0.86, 0.86, 0.83);
  this->Actor->GetProperty()->SetEdgeColor(0.6, 0.6, 0.6);
  // Lines on the surface are drawn before it.
  this->Mapper->SetResolveCoincidentTopologyToPolygonOffset();
  this->Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(3.0, 20.0);
  this->Boundary->SetMapper(this->EdgeMapper);
  this->Boundary->GetProperty()->SetColor(0.0, 0.0, 0.0);
  this->Boundary->GetProperty()->SetLineWidth(2.0F);
  this->EdgeMapper->ScalarVisibilityOff();
  this->Ghosts->SetMapper(this->GhostMapper);
  this->Ghosts->GetProperty()->SetLineWidth(5.0F);
  this->Ghosts->GetProperty()->LightingOff();
  this->Ghosts->PickableOff();
  this->Ghosts->VisibilityOff();
  this->GhostMapper->SetResolveCoincidentTopologyToPolygonOffset();
  this->GhostMapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -300.0);
  renderer->AddViewProp(this->Ghosts);
  renderer->AddViewProp(this->Actor);
  renderer->AddViewProp(this->Boundary);
}

void SpaceView::setSurface(const figures::PolyData& surface)
{
  this->Surface = surface;
  this->Mapper->SetInputData(surface);
  this->Mapper->ScalarVisibilityOff();
  this->EdgeMapper->SetInputData(figures::boundaryOf(surface));
  this->resetCamera();
}

void SpaceView::color(const figures::FlatPiece& piece, figures::Coloring coloring)
{
  const figures::ColorMap map = figures::makeColorMap(coloring, piece);
  this->Mapper->SetInputData(piece.cut);
  figures::colorBy(this->Mapper, map.array, map.onPoints, map.colors);
}

void SpaceView::setEdges(bool shown)
{
  this->Actor->GetProperty()->SetEdgeVisibility(shown ? 1 : 0);
}

void SpaceView::showGhosts(const figures::PolyData& lines, std::size_t chosen)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    const bool strong = line == static_cast<vtkIdType>(chosen);
    const std::array<unsigned char, 4> color = strong ? strongGhost : paleGhost;
    colors->InsertNextTypedTuple(color.data());
  }
  lines->GetCellData()->SetScalars(colors);
  this->GhostMapper->SetInputData(lines);
  this->Ghosts->SetVisibility(lines->GetNumberOfCells() > 0 ? 1 : 0);
}

void SpaceView::resetCamera()
{
  if (this->Surface)
  {
    this->lookFrom(figures::facing(this->Surface));
  }
}

void SpaceView::lookFrom(const figures::Vector& back)
{
  if (!this->Surface)
  {
    return;
  }
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  double center[3];
  this->Surface->GetCenter(center);
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + back[0], center[1] + back[1], center[2] + back[2]);
  camera->SetViewUp(0.0, 1.0, 0.0);
  if (std::abs(back[1]) > 0.9)
  {
    camera->SetViewUp(0.0, 0.0, 1.0);
  }
  double bounds[6];
  this->Surface->GetBounds(bounds);
  this->Renderer->ResetCamera(bounds);
  // VTK's own whole view leaves room for every turn; this one fills the window.
  double up[3];
  double along[3];
  double right[3];
  camera->OrthogonalizeViewUp();
  camera->GetViewUp(up);
  camera->GetDirectionOfProjection(along);
  vtkMath::Cross(along, up, right);
  double height = 0.0;
  double width = 0.0;
  for (vtkIdType k = 0; k < this->Surface->GetNumberOfPoints(); ++k)
  {
    double way[3];
    vtkMath::Subtract(this->Surface->GetPoint(k), center, way);
    height = std::max(height, std::abs(vtkMath::Dot(way, up)));
    width = std::max(width, std::abs(vtkMath::Dot(way, right)));
  }
  camera->SetParallelScale(
    surfaceMargin * std::max(height, width / this->Renderer->GetTiledAspectRatio()));
}
}
