// SPDX-License-Identifier: BSD-3-Clause
#include "SpaceView.h"

#include "Drawing.h"

#include <vtkCamera.h>
#include <vtkFeatureEdges.h>
#include <vtkProperty.h>

#include <cmath>

namespace editor
{
namespace
{
constexpr double closer = 1.3; // than VTK's own whole view, which leaves room for every turn
}

//------------------------------------------------------------------------------
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
  renderer->AddViewProp(this->Actor);
  renderer->AddViewProp(this->Boundary);
}

//------------------------------------------------------------------------------
void SpaceView::setSurface(const figures::PolyData& surface)
{
  this->Surface = surface;
  this->Mapper->SetInputData(surface);
  this->Mapper->ScalarVisibilityOff();
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  this->EdgeMapper->SetInputData(edges->GetOutput());
  this->resetCamera();
}

//------------------------------------------------------------------------------
void SpaceView::color(const figures::FlatPiece& piece, figures::Coloring coloring)
{
  const figures::ColorMap map = figures::makeColorMap(coloring, piece.flat);
  this->Mapper->SetInputData(piece.cut);
  this->Mapper->SetLookupTable(map.colors);
  this->Mapper->UseLookupTableScalarRangeOn();
  map.onPoints ? this->Mapper->SetScalarModeToUsePointFieldData()
               : this->Mapper->SetScalarModeToUseCellFieldData();
  this->Mapper->SelectColorArray(map.array);
  this->Mapper->ScalarVisibilityOn();
}

//------------------------------------------------------------------------------
void SpaceView::setEdges(bool shown)
{
  this->Actor->GetProperty()->SetEdgeVisibility(shown ? 1 : 0);
}

//------------------------------------------------------------------------------
void SpaceView::resetCamera()
{
  if (!this->Surface)
  {
    return;
  }
  const figures::Vector back = figures::facing(this->Surface);
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
  camera->Zoom(closer);
}
}
