// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneView.h"

#include "Drawing.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace editor
{
namespace
{
constexpr double pieceMargin = 1.12;
constexpr float wireWidth = 3.0F;    // pixels
constexpr double shareOfScale = 0.1; // of the view's height, with its title
constexpr double dimOpacity = 0.35;

vtkIdType pieceCount(vtkPolyData* flat)
{
  vtkDataArray* const ids = flat->GetCellData()->GetArray("PieceId");
  return ids && ids->GetNumberOfTuples() > 0 ? static_cast<vtkIdType>(ids->GetRange()[1]) + 1 : 0;
}

/// The wires with a color each, in the order in which they are drawn. The sides of a dart are shown
/// as such, although they bound the piece.
figures::PolyData colored(const figures::PolyData& wires)
{
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  // No lines of the pattern. Black as the outline they looked like cuts.
  vtkDataArray* const connectors = wires->GetCellData()->GetArray("Connector");
  vtkNew<vtkIdList> ids;
  for (const figures::WireGroup& group : figures::groupWires(wires, figures::DartSides::Blue))
  {
    for (const vtkIdType cell : group.cells)
    {
      if (!connectors || connectors->GetComponent(cell, 0) == 0.0)
      {
        wires->GetCellPoints(cell, ids);
        lines->InsertNextCell(ids);
        const figures::Vector& color = group.color;
        colors->InsertNextTuple3(255.0 * color[0], 255.0 * color[1], 255.0 * color[2]);
      }
    }
  }
  figures::PolyData drawn = figures::PolyData::New();
  drawn->SetPoints(wires->GetPoints());
  drawn->SetLines(lines);
  drawn->GetCellData()->SetScalars(colors);
  return drawn;
}
}

PlaneView::PlaneView(vtkRenderer* renderer)
  : Renderer(renderer)
{
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->LightingOff();
  this->Wires->SetMapper(this->WireMapper);
  this->Wires->GetProperty()->LightingOff();
  this->Wires->GetProperty()->SetLineWidth(wireWidth);
  this->Mapper->SetResolveCoincidentTopologyToPolygonOffset();
  this->Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 10.0);
  this->WireMapper->SetResolveCoincidentTopologyToPolygonOffset();
  this->WireMapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -10.0);
  for (vtkActor* actor : { this->Actor.Get(), this->Wires.Get() })
  {
    actor->VisibilityOff();
    renderer->AddViewProp(actor);
  }
  this->Title->VisibilityOff();
  renderer->AddViewProp(this->Title);
}

void PlaneView::start(vtkPolyData* surface, vtkCamera* camera)
{
  figures::Vector right;
  figures::Vector up;
  figures::Vector along;
  camera->OrthogonalizeViewUp();
  camera->GetViewUp(up.data());
  camera->GetDirectionOfProjection(along.data());
  vtkMath::Cross(along.data(), up.data(), right.data());
  this->Steady.start(surface, right, up);
  this->Actor->VisibilityOff();
  this->Wires->VisibilityOff();
  this->Title->VisibilityOff();
  if (this->Scale)
  {
    this->Scale->VisibilityOff();
  }
  this->Shown = {};
  this->CameraSet = false;
}

void PlaneView::show(const figures::FlatPiece& piece, figures::Coloring coloring)
{
  const figures::FlatPiece settled = this->Steady.settle(piece);
  const figures::ColorMap map = figures::makeColorMap(coloring, settled);
  this->Mapper->SetInputData(settled.flat);
  this->Mapper->SetInterpolateScalarsBeforeMapping(map.onPoints ? 1 : 0);
  figures::colorBy(this->Mapper, map.array, map.onPoints, map.colors);
  this->WireMapper->SetInputData(colored(settled.wires));
  this->Actor->VisibilityOn();
  this->Wires->VisibilityOn();
  this->Shown = settled;
  this->showScale(map);
  const vtkIdType count = pieceCount(settled.flat);
  if (!this->CameraSet || count != this->PieceCount)
  {
    this->resetCamera(settled.flat);
    this->CameraSet = true;
    this->PieceCount = count;
  }
  this->Renderer->ResetCameraClippingRange();
}

void PlaneView::dim(bool on)
{
  this->Dim = on;
  for (vtkActor* actor : { this->Actor.Get(), this->Wires.Get() })
  {
    actor->GetProperty()->SetOpacity(on ? dimOpacity : 1.0);
  }
}

void PlaneView::showScale(const figures::ColorMap& map)
{
  // Shares of the view.
  constexpr double left = 0.02;
  constexpr double below = 0.015;
  constexpr double width = 0.7;
  constexpr double height = 0.055;
  constexpr int textSize = 13;
  if (this->Scale)
  {
    this->Renderer->RemoveViewProp(this->Scale);
  }
  this->Scale = figures::makeScaleBar(map.colors, map.labels, textSize);
  this->Scale->SetPosition(left, below);
  this->Scale->SetPosition2(width, height);
  this->Renderer->AddViewProp(this->Scale);
  vtkCoordinate* const place = this->Title->GetPositionCoordinate();
  place->SetCoordinateSystemToNormalizedViewport();
  place->SetValue(left, below + height + 0.005);
  this->Title->GetTextProperty()->SetFontSize(textSize);
  this->Title->GetTextProperty()->SetColor(0.0, 0.0, 0.0);
  this->Title->SetInput(map.title.c_str());
  this->Title->VisibilityOn();
}

void PlaneView::resetCamera(vtkPolyData* flat)
{
  double bounds[6];
  flat->GetBounds(bounds);
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  const double width = bounds[1] - bounds[0];
  const double height = bounds[3] - bounds[2];
  // The pieces have what the scale leaves of the view.
  const double seen = pieceMargin *
    std::max(height / (1.0 - shareOfScale), width / this->Renderer->GetTiledAspectRatio());
  const double center[2] = { 0.5 * (bounds[0] + bounds[1]),
    0.5 * (bounds[2] + bounds[3]) - 0.5 * shareOfScale * seen };
  camera->SetFocalPoint(center[0], center[1], 0.0);
  camera->SetPosition(center[0], center[1], width + height);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(0.5 * seen);
}
}
