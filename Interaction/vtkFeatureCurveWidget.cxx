// SPDX-License-Identifier: BSD-3-Clause
// The state of vtkFeatureCurveWidget and its words; the mouse and the actions are in files of their
// own.
#include "vtkFeatureCurveWidget.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using interaction::CurveChoice;

vtkStandardNewMacro(vtkFeatureCurveWidget);

namespace
{
/// By SnapTargets.
constexpr std::array<const char*, 7> targetNames{ "", "boundary", "corner", "vertex", "curve",
  "dart tip", "mirror plane" };

std::string shortNumber(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}

std::string lengthIn(const std::string& unit, double length)
{
  return shortNumber(length) + (unit.empty() ? "" : " ") + unit;
}
}

//------------------------------------------------------------------------------
vtkFeatureCurveWidget::vtkFeatureCurveWidget()
{
  this->Priority = 0.5F; // before the interactor's style
  this->EventCallbackCommand->SetCallback(vtkFeatureCurveWidget::Dispatch);
  this->KeyPressActivationOff();
}

//------------------------------------------------------------------------------
vtkFeatureCurveWidget::~vtkFeatureCurveWidget()
{
  this->SetEditor(nullptr);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Reach: " << this->Reach << "\n";
  os << indent << "StrokeTolerance: " << this->StrokeTolerance << "\n";
  os << indent << "HandleKeys: " << this->HandleKeys << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "Hint: " << this->Hint << "\n";
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::SetEditor(vtkFeatureCurveEditor* editor)
{
  if (this->Editor)
  {
    this->Editor->RemoveObserver(this->EditorTag);
  }
  this->Editor = editor;
  if (editor)
  {
    this->EditorTag =
      editor->AddObserver(vtkCommand::ModifiedEvent, this, &vtkFeatureCurveWidget::FollowEditor);
    this->Redraw();
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::SetSurface(vtkPolyData* surface)
{
  this->Picker.setSurface(surface);
  this->State = Mode::Choosing;
  this->Choose(-1, -1);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::SetCurveRenderer(vtkRenderer* renderer)
{
  this->CurveRenderer = renderer;
}

//------------------------------------------------------------------------------
vtkRenderer* vtkFeatureCurveWidget::LayerOfCurves()
{
  return this->CurveRenderer ? this->CurveRenderer.Get() : this->DefaultRenderer;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::SetEnabled(int enabled)
{
  if (!this->Interactor || !this->DefaultRenderer || (enabled != 0) == (this->Enabled != 0))
  {
    return;
  }
  this->Enabled = enabled;
  if (!enabled)
  {
    this->Interactor->RemoveObserver(this->EventCallbackCommand);
    this->Actors.hide(this->LayerOfCurves());
    this->InvokeEvent(vtkCommand::DisableEvent, nullptr);
    return;
  }
  for (const unsigned long event :
    { vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
      vtkCommand::LeftButtonDoubleClickEvent, vtkCommand::RightButtonPressEvent,
      vtkCommand::MouseMoveEvent, vtkCommand::KeyPressEvent, vtkCommand::CharEvent })
  {
    this->Interactor->AddObserver(event, this->EventCallbackCommand, this->Priority);
  }
  this->Actors.show(this->LayerOfCurves());
  this->Redraw();
  this->InvokeEvent(vtkCommand::EnableEvent, nullptr);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::Choose(int curve, int node)
{
  const int drawn = this->State == Mode::Drawing ? this->Chosen.curve : -1;
  if (drawn >= 0 && curve != drawn)
  {
    const bool kept = this->EndDrawing();
    curve -= !kept && curve > drawn ? 1 : 0;
  }
  this->Select(curve, node);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::Select(int curve, int node)
{
  const CurveChoice chosen{ curve, curve < 0 ? -1 : node };
  if (!(chosen == this->Chosen))
  {
    this->Chosen = chosen;
    this->InvokeEvent(vtkCommand::SelectionChangedEvent, nullptr);
  }
  this->Redraw();
  this->UpdateHint({});
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::FollowEditor()
{
  this->Redraw();
  if (this->State != Mode::Dragging)
  {
    this->UpdateHint({});
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::Redraw()
{
  if (!this->Editor)
  {
    return;
  }
  // What was chosen may have gone by an undo.
  if (this->Chosen.curve >= this->Editor->GetNumberOfCurves())
  {
    this->Chosen = {};
    this->InvokeEvent(vtkCommand::SelectionChangedEvent, nullptr);
  }
  this->Chosen.node =
    std::min(this->Chosen.node, this->Editor->GetNumberOfNodes(this->Chosen.curve) - 1);
  this->Actors.hideMarker();
  this->Actors.drawCurves(*this->Editor, this->Chosen);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::Render()
{
  if (this->Interactor && this->Enabled)
  {
    this->Interactor->Render();
  }
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::Finished(bool done)
{
  return done || this->Refuse(this->Editor->GetMessage());
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::Refuse(const std::string& words)
{
  this->SetHint(words);
  std::string data = words;
  this->InvokeEvent(vtkCommand::WarningEvent, data.data());
  return false;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::SetHint(const std::string& hint)
{
  if (hint != this->Hint)
  {
    this->Hint = hint;
    this->InvokeEvent(vtkCommand::CursorChangedEvent, nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::SetLengthUnit(const std::string& unit)
{
  if (unit != this->LengthUnit)
  {
    this->LengthUnit = unit;
    this->Modified();
    this->UpdateHint(Aim());
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::UpdateHint(const Aim& aim)
{
  if (!this->Editor)
  {
    return;
  }
  const int curve = this->Chosen.curve;
  const int count = this->Editor->GetNumberOfNodes(curve);
  std::string words;
  if (count > 0)
  {
    words = this->Editor->GetCurveName(curve) + ": " +
      interaction::nameOfType(this->Editor->GetCurveType(curve)) + ", " +
      (count == 1 ? "one node. "
                  : "length " + lengthIn(this->LengthUnit, this->Editor->GetCurveLength(curve)) +
            ", " + std::to_string(count) + " nodes. ");
  }
  std::string label;
  if (this->State == Mode::Drawing)
  {
    label = aim.onSurface ? targetNames[static_cast<std::size_t>(aim.snapped)] : "";
    if (count > 0 && aim.onSurface)
    {
      double last[3];
      this->Editor->GetNode(curve, count - 1, last);
      const double length =
        this->Editor->PreviewSegment(last, aim.point.data(), this->Kind, this->Actors.preview());
      label = length < 0.0 ? "no way there" : lengthIn(this->LengthUnit, length) + " " + label;
    }
    words += count == 0 ? "Click where the curve starts."
                        : "Click to go on; Return or the right button ends the curve.";
  }
  else if (this->State == Mode::Offsetting)
  {
    if (aim.onSurface)
    {
      const double distance = this->Editor->GetDistance(curve, aim.point.data());
      label = std::isfinite(distance) ? lengthIn(this->LengthUnit, std::abs(distance)) + " away"
                                      : "no way there";
    }
    words += "Click where the offset is to run; Return leaves it.";
  }
  else if (this->State == Mode::Sketching)
  {
    words = "Draw a curve with the left button held; Return leaves it.";
  }
  else if (this->State == Mode::Dragging && this->Chosen.node >= 0)
  {
    const int segments = this->Editor->GetNumberOfSegments(curve);
    const int before = this->Chosen.node > 0 ? this->Chosen.node - 1
      : this->Editor->GetCurveClosed(curve)  ? segments - 1
                                             : -1;
    for (const int segment : { before, this->Chosen.node })
    {
      if (segment >= 0 && segment < segments)
      {
        label += (label.empty() ? "" : " | ") +
          lengthIn(this->LengthUnit, this->Editor->GetSegmentLength(curve, segment));
      }
    }
  }
  else if (this->State == Mode::Choosing)
  {
    // Who expects a click to draw looks here, not at the hint below.
    const bool bare = aim.onSurface && aim.node.curve < 0 && aim.line.curve < 0;
    if (count == 0 && bare && (this->Missed || this->Editor->GetNumberOfCurves() == 0))
    {
      label = "press N to draw a curve";
    }
    words += count == 0 ? "N draws a curve; click one to choose it, drag its nodes."
                        : "Drag nodes; Ctrl+click on the curve inserts one.";
  }
  const int* const pixel = this->Interactor ? this->Interactor->GetEventPosition() : nullptr;
  if (pixel)
  {
    this->Actors.drawLabel(label, { pixel[0], pixel[1] });
  }
  this->SetHint(words);
}
