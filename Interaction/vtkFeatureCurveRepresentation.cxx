// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveRepresentation.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>

vtkStandardNewMacro(vtkFeatureCurveRepresentation);

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

/// Lines or points with a color for each cell.
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
struct vtkFeatureCurveRepresentation::Parts
{
  struct Layer
  {
    /// @param units by which it is drawn before the surface
    Layer(double size, double units)
    {
      this->mapper->SetInputData(this->data);
      this->mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, units);
      this->mapper->SetRelativeCoincidentTopologyPointOffsetParameter(units);
      this->mapper->SetResolveCoincidentTopologyToPolygonOffset();
      this->actor->SetMapper(this->mapper);
      this->actor->PickableOff();
      vtkProperty* const property = this->actor->GetProperty();
      property->SetLineWidth(static_cast<float>(size));
      property->SetPointSize(static_cast<float>(size));
      property->RenderPointsAsSpheresOn();
      property->LightingOff();
    }

    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };

  // The later layers are drawn before the earlier.
  Layer chosenLine{ 8.0, -200.0 };
  Layer lines{ 4.0, -400.0 };
  Layer preview{ 3.0, -500.0 };
  Layer nodes{ 9.0, -600.0 };
  Layer chosenNode{ 14.0, -700.0 };
  Layer marker{ 16.0, -800.0 };
  vtkNew<vtkTextActor> label;

  std::array<vtkActor*, 6> actors() const
  {
    return { this->chosenLine.actor, this->lines.actor, this->preview.actor, this->nodes.actor,
      this->chosenNode.actor, this->marker.actor };
  }
};

//------------------------------------------------------------------------------
vtkFeatureCurveRepresentation::vtkFeatureCurveRepresentation()
  : Drawn(std::make_unique<Parts>())
{
  this->PickableOff();
  setColor(this->Drawn->preview.actor, chosenColor);
  this->Drawn->marker.actor->GetProperty()->SetOpacity(0.6);
  vtkTextProperty* const words = this->Drawn->label->GetTextProperty();
  words->SetFontSize(14);
  words->SetColor(0.1, 0.1, 0.1);
  words->SetBackgroundColor(1.0, 1.0, 1.0);
  words->SetBackgroundOpacity(0.8);
  this->HideMarker();
}

//------------------------------------------------------------------------------
vtkFeatureCurveRepresentation::~vtkFeatureCurveRepresentation() = default;

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ChosenCurve: " << this->ChosenCurve << "\n";
  os << indent << "ChosenNode: " << this->ChosenNode << "\n";
}

//------------------------------------------------------------------------------
const char* vtkFeatureCurveRepresentation::GetTypeName(int type)
{
  return typeNames[static_cast<std::size_t>(std::clamp(type, 0, 3))];
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::GetTypeColor(int type, unsigned char color[3])
{
  const Color& ofType = typeColors[static_cast<std::size_t>(std::clamp(type, 0, 3))];
  std::copy(ofType.begin(), ofType.end(), color);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::SetEditor(vtkFeatureCurveEditor* editor)
{
  this->Editor = editor;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::SetChosen(int curve, int node)
{
  this->ChosenCurve = curve;
  this->ChosenNode = node;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::BuildRepresentation()
{
  CellWriter lines;
  CellWriter chosenLine;
  CellWriter nodes;
  CellWriter chosenNode;
  vtkNew<vtkPolyData> line;
  double point[3];
  const int curves = this->Editor ? this->Editor->GetNumberOfCurves() : 0;
  for (int curve = 0; curve < curves; ++curve)
  {
    this->Editor->GetCurve(curve, line);
    Color color;
    GetTypeColor(this->Editor->GetCurveType(curve), color.data());
    lines.addLines(line, color);
    if (curve == this->ChosenCurve)
    {
      chosenLine.addLines(line, chosenColor);
    }
    for (int node = 0; node < this->Editor->GetNumberOfNodes(curve); ++node)
    {
      this->Editor->GetNode(curve, node, point);
      nodes.addPoint(point, nodeColor);
      if (curve == this->ChosenCurve && node == this->ChosenNode)
      {
        chosenNode.addPoint(point, chosenColor);
      }
    }
  }
  lines.giveLines(this->Drawn->lines.data);
  chosenLine.giveLines(this->Drawn->chosenLine.data);
  nodes.givePoints(this->Drawn->nodes.data);
  chosenNode.givePoints(this->Drawn->chosenNode.data);
  this->BuildTime.Modified();
}

//------------------------------------------------------------------------------
vtkPolyData* vtkFeatureCurveRepresentation::GetPreview()
{
  return this->Drawn->preview.data;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::DrawStroke(vtkPoints* points)
{
  vtkNew<vtkPoints> copy;
  copy->DeepCopy(points);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(copy->GetNumberOfPoints()));
  for (vtkIdType k = 0; k < copy->GetNumberOfPoints(); ++k)
  {
    line->InsertCellPoint(k);
  }
  this->Drawn->preview.data->Initialize();
  this->Drawn->preview.data->SetPoints(copy);
  this->Drawn->preview.data->SetLines(line);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::DrawMarker(const double point[3], bool snapped)
{
  CellWriter place;
  place.addPoint(point, snapped ? chosenColor : nodeColor);
  place.givePoints(this->Drawn->marker.data);
  this->Drawn->marker.actor->SetVisibility(1);
  this->Drawn->marker.actor->GetProperty()->SetPointSize(snapped ? 16.0F : 8.0F);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::DrawLabel(const std::string& text, int x, int y)
{
  vtkTextActor* const label = this->Drawn->label;
  label->SetInput(text.c_str());
  // On the other side of the mouse where the window ends.
  bool fits = true;
  if (this->Renderer)
  {
    double size[2];
    label->GetSize(this->Renderer, size);
    fits =
      x + labelGap + static_cast<int>(size[0]) <= this->Renderer->GetRenderWindow()->GetSize()[0];
  }
  label->GetTextProperty()->SetJustification(fits ? VTK_TEXT_LEFT : VTK_TEXT_RIGHT);
  label->SetPosition(x + (fits ? labelGap : -labelGap), y + labelGap);
  label->SetVisibility(text.empty() ? 0 : 1);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::HideMarker()
{
  this->Drawn->marker.actor->SetVisibility(0);
  this->Drawn->label->SetVisibility(0);
  this->Drawn->preview.data->Initialize();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkFeatureCurveRepresentation::GetRedrawMTime()
{
  vtkMTimeType latest = std::max(this->GetMTime(), this->Drawn->label->GetMTime());
  for (vtkActor* actor : this->Drawn->actors())
  {
    latest = std::max(latest, actor->GetRedrawMTime());
  }
  return latest;
}

//------------------------------------------------------------------------------
double* vtkFeatureCurveRepresentation::GetBounds()
{
  vtkBoundingBox box;
  for (vtkActor* actor : this->Drawn->actors())
  {
    if (actor->GetVisibility())
    {
      box.AddBounds(actor->GetBounds());
    }
  }
  if (!box.IsValid())
  {
    return nullptr;
  }
  box.GetBounds(this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::GetActors(vtkPropCollection* actors)
{
  for (vtkActor* actor : this->Drawn->actors())
  {
    actors->AddItem(actor);
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::GetActors2D(vtkPropCollection* actors)
{
  actors->AddItem(this->Drawn->label);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkActor* actor : this->Drawn->actors())
  {
    actor->ReleaseGraphicsResources(window);
  }
  this->Drawn->label->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  int rendered = 0;
  for (vtkActor* actor : this->Drawn->actors())
  {
    rendered += actor->GetVisibility() ? actor->RenderOpaqueGeometry(viewport) : 0;
  }
  return rendered;
}

//------------------------------------------------------------------------------
int vtkFeatureCurveRepresentation::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  int rendered = 0;
  for (vtkActor* actor : this->Drawn->actors())
  {
    rendered += actor->GetVisibility() ? actor->RenderTranslucentPolygonalGeometry(viewport) : 0;
  }
  return rendered;
}

//------------------------------------------------------------------------------
int vtkFeatureCurveRepresentation::RenderOverlay(vtkViewport* viewport)
{
  return this->Drawn->label->GetVisibility() ? this->Drawn->label->RenderOverlay(viewport) : 0;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkFeatureCurveRepresentation::HasTranslucentPolygonalGeometry()
{
  const auto actors = this->Drawn->actors();
  return std::any_of(actors.begin(), actors.end(), [](vtkActor* actor) {
    return actor->GetVisibility() && actor->HasTranslucentPolygonalGeometry();
  });
}
