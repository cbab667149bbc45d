// SPDX-License-Identifier: BSD-3-Clause
#include "CurveActors.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace interaction
{
namespace
{
using Color = std::array<unsigned char, 3>;

constexpr std::array<const char*, 4> typeNames{ "accessory", "key", "dart", "seam" };
// Of these types, as in the figures.
constexpr std::array<Color, 4> typeColors{ { { 0, 153, 26 }, { 217, 0, 0 }, { 0, 51, 230 },
  { 153, 0, 191 } } };
constexpr Color chosenColor{ 255, 150, 0 };
constexpr Color nodeColor{ 40, 40, 40 };
constexpr int labelGap = 13; // pixels

void setColor(vtkActor* actor, const Color& color)
{
  actor->GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
}

/// Lines or points with a colour for each cell.
class CellWriter
{
public:
  CellWriter()
  {
    this->Points->SetDataTypeToDouble();
    this->Colors->SetNumberOfComponents(3);
  }

  void addLines(vtkPolyData* lines, const Color& color)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (vtkIdType k = 0; k < lines->GetNumberOfPoints(); ++k)
    {
      this->Points->InsertNextPoint(lines->GetPoint(k));
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
    {
      lines->GetCellPoints(cell, ids);
      this->Cells->InsertNextCell(static_cast<int>(ids->GetNumberOfIds()));
      for (const vtkIdType id : *ids)
      {
        this->Cells->InsertCellPoint(first + id);
      }
      this->Colors->InsertNextTypedTuple(color.data());
    }
  }
  void addPoint(const double point[3], const Color& color)
  {
    const vtkIdType id = this->Points->InsertNextPoint(point);
    this->Cells->InsertNextCell(1, &id);
    this->Colors->InsertNextTypedTuple(color.data());
  }
  void giveLines(vtkPolyData* data) { this->give(data, true); }
  void givePoints(vtkPolyData* data) { this->give(data, false); }

private:
  void give(vtkPolyData* data, bool lines)
  {
    data->Initialize();
    data->SetPoints(this->Points);
    lines ? data->SetLines(this->Cells) : data->SetVerts(this->Cells);
    data->GetCellData()->SetScalars(this->Colors);
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkUnsignedCharArray> Colors;
};
}

//------------------------------------------------------------------------------
const char* nameOfType(int type)
{
  return typeNames[static_cast<std::size_t>(std::clamp(type, 0, 3))];
}

//------------------------------------------------------------------------------
std::array<unsigned char, 3> colorOfType(int type)
{
  return typeColors[static_cast<std::size_t>(std::clamp(type, 0, 3))];
}

//------------------------------------------------------------------------------
CurveActors::CurveActors()
{
  // What lies on the surface is drawn a little before it, the later layers before the earlier.
  this->makeLayer(this->ChosenLine, 8.0, -200.0);
  this->makeLayer(this->Lines, 4.0, -400.0);
  this->makeLayer(this->Preview, 3.0, -500.0);
  this->makeLayer(this->Nodes, 9.0, -600.0);
  this->makeLayer(this->ChosenNode, 14.0, -700.0);
  this->makeLayer(this->Marker, 16.0, -800.0);
  setColor(this->Preview.actor, chosenColor);
  this->Marker.actor->GetProperty()->SetOpacity(0.6);
  vtkTextProperty* const words = this->Label->GetTextProperty();
  words->SetFontSize(14);
  words->SetColor(0.1, 0.1, 0.1);
  words->SetBackgroundColor(1.0, 1.0, 1.0);
  words->SetBackgroundOpacity(0.8);
  this->Label->SetVisibility(0);
}

//------------------------------------------------------------------------------
void CurveActors::makeLayer(Layer& layer, double size, double units)
{
  layer.mapper->SetInputData(layer.data);
  layer.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, units);
  layer.mapper->SetRelativeCoincidentTopologyPointOffsetParameter(units);
  layer.mapper->SetResolveCoincidentTopologyToPolygonOffset();
  layer.actor->SetMapper(layer.mapper);
  layer.actor->PickableOff();
  vtkProperty* const property = layer.actor->GetProperty();
  property->SetLineWidth(static_cast<float>(size));
  property->SetPointSize(static_cast<float>(size));
  property->RenderPointsAsSpheresOn();
  property->LightingOff();
}

//------------------------------------------------------------------------------
void CurveActors::show(vtkRenderer* renderer)
{
  for (Layer* layer : { &this->ChosenLine, &this->Lines, &this->Preview, &this->Nodes,
         &this->ChosenNode, &this->Marker })
  {
    renderer->AddViewProp(layer->actor);
  }
  renderer->AddViewProp(this->Label);
  this->Renderer = renderer;
}

//------------------------------------------------------------------------------
void CurveActors::hide(vtkRenderer* renderer)
{
  for (Layer* layer : { &this->ChosenLine, &this->Lines, &this->Preview, &this->Nodes,
         &this->ChosenNode, &this->Marker })
  {
    renderer->RemoveViewProp(layer->actor);
  }
  renderer->RemoveViewProp(this->Label);
  this->Renderer = nullptr;
}

//------------------------------------------------------------------------------
void CurveActors::drawCurves(const vtkFeatureCurveEditor& editor, const CurveChoice& chosen) const
{
  CellWriter lines;
  CellWriter chosenLine;
  CellWriter nodes;
  CellWriter chosenNode;
  vtkNew<vtkPolyData> line;
  double point[3];
  for (int curve = 0; curve < editor.GetNumberOfCurves(); ++curve)
  {
    editor.GetCurve(curve, line);
    lines.addLines(line, colorOfType(editor.GetCurveType(curve)));
    if (curve == chosen.curve)
    {
      chosenLine.addLines(line, chosenColor);
    }
    for (int node = 0; node < editor.GetNumberOfNodes(curve); ++node)
    {
      editor.GetNode(curve, node, point);
      nodes.addPoint(point, nodeColor);
      if (curve == chosen.curve && node == chosen.node)
      {
        chosenNode.addPoint(point, chosenColor);
      }
    }
  }
  lines.giveLines(this->Lines.data);
  chosenLine.giveLines(this->ChosenLine.data);
  nodes.givePoints(this->Nodes.data);
  chosenNode.givePoints(this->ChosenNode.data);
}

//------------------------------------------------------------------------------
void CurveActors::drawStroke(vtkPoints* points) const
{
  vtkNew<vtkPoints> copy;
  copy->DeepCopy(points);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(copy->GetNumberOfPoints()));
  for (vtkIdType k = 0; k < copy->GetNumberOfPoints(); ++k)
  {
    line->InsertCellPoint(k);
  }
  this->Preview.data->Initialize();
  this->Preview.data->SetPoints(copy);
  this->Preview.data->SetLines(line);
}

//------------------------------------------------------------------------------
void CurveActors::drawMarker(const std::array<double, 3>& point, bool snapped) const
{
  CellWriter place;
  place.addPoint(point.data(), snapped ? chosenColor : nodeColor);
  place.givePoints(this->Marker.data);
  this->Marker.actor->SetVisibility(1);
  this->Marker.actor->GetProperty()->SetPointSize(snapped ? 16.0F : 8.0F);
}

//------------------------------------------------------------------------------
void CurveActors::drawLabel(const std::string& text, const std::array<int, 2>& pixel)
{
  this->Label->SetInput(text.c_str());
  // On the other side of the mouse where the window ends.
  const bool fits = this->Renderer == nullptr ||
    pixel[0] + labelGap + this->labelWidth() <= this->Renderer->GetRenderWindow()->GetSize()[0];
  this->Label->GetTextProperty()->SetJustification(fits ? VTK_TEXT_LEFT : VTK_TEXT_RIGHT);
  this->Label->SetPosition(pixel[0] + (fits ? labelGap : -labelGap), pixel[1] + labelGap);
  this->Label->SetVisibility(text.empty() ? 0 : 1);
}

//------------------------------------------------------------------------------
int CurveActors::labelWidth()
{
  double size[2];
  this->Label->GetSize(this->Renderer, size);
  return static_cast<int>(size[0]);
}

//------------------------------------------------------------------------------
void CurveActors::hideMarker()
{
  this->Marker.actor->SetVisibility(0);
  this->Label->SetVisibility(0);
  this->Preview.data->Initialize();
}
}
