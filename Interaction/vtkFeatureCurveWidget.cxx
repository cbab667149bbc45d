// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveWidget.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkInteractorStyle.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using interaction::CurveChoice;

vtkStandardNewMacro(vtkFeatureCurveWidget);

namespace
{
constexpr int stillHand = 3; // pixels that a click may move

/// By SnapTargets.
constexpr std::array<const char*, 7> targetNames{ "", "boundary", "corner", "vertex", "curve",
  "dart tip", "mirror plane" };
constexpr std::array<const char*, 4> typeNames{ "accessory", "key", "dart", "seam" };

std::string shortNumber(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
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
  os << indent << "HandleKeys: " << this->HandleKeys << "\n";
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
    this->Actors.hide(this->DefaultRenderer);
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
  this->Actors.show(this->DefaultRenderer);
  this->Redraw();
  this->InvokeEvent(vtkCommand::EnableEvent, nullptr);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::Dispatch(vtkObject*, unsigned long event, void* client, void*)
{
  auto* const self = static_cast<vtkFeatureCurveWidget*>(client);
  if (!self->Editor)
  {
    return;
  }
  self->CurrentEvent = event;
  switch (event)
  {
    case vtkCommand::LeftButtonPressEvent:
      self->OnPress();
      break;
    case vtkCommand::LeftButtonReleaseEvent:
      self->OnRelease();
      break;
    case vtkCommand::LeftButtonDoubleClickEvent:
      self->Do(FINISH);
      break;
    case vtkCommand::RightButtonPressEvent:
      self->OnRightPress();
      break;
    case vtkCommand::MouseMoveEvent:
      self->OnMove();
      break;
    default:
      self->OnKey();
  }
}

//------------------------------------------------------------------------------
vtkFeatureCurveWidget::Aim vtkFeatureCurveWidget::AimAt(int exceptCurve) const
{
  Aim aim;
  const int* const position = this->Interactor->GetEventPosition();
  const std::array<int, 2> pixel{ position[0], position[1] };
  interaction::SurfacePick picked;
  if (!this->DefaultRenderer->IsInViewport(pixel[0], pixel[1]) ||
    !this->Picker.pick(this->DefaultRenderer, pixel, this->Reach, picked))
  {
    return aim;
  }
  aim.onSurface = true;
  const double reach = this->Reach * picked.pixel;
  const double* const point = picked.point.data();
  double view[3];
  this->DefaultRenderer->GetActiveCamera()->GetDirectionOfProjection(view);
  this->Editor->SetViewDirection(view);
  const bool snap = this->Snapping && !this->Interactor->GetAltKey();
  aim.snapped = this->Editor->SnapPoint(point, snap ? reach : 0.0, exceptCurve, aim.point.data());
  int found[2];
  if (this->Editor->FindNode(point, reach, found))
  {
    aim.node = { found[0], found[1] };
  }
  if (this->Editor->FindSegment(point, reach, found))
  {
    aim.line = { found[0], found[1] };
  }
  return aim;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::HasMoved() const
{
  const int* const now = this->Interactor->GetEventPosition();
  return std::abs(now[0] - this->Pressed[0]) > stillHand ||
    std::abs(now[1] - this->Pressed[1]) > stillHand;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::OnPress()
{
  const int* const position = this->Interactor->GetEventPosition();
  this->Pressed = { position[0], position[1] };
  this->PressedHere = this->DefaultRenderer->IsInViewport(position[0], position[1]) != 0;
  if (this->PressedHere)
  {
    // The style would take all that follows for itself. It gets the press when it is no click.
    this->EventCallbackCommand->SetAbortFlag(1);
    if (this->State == Mode::Choosing)
    {
      this->StartDrag();
    }
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::HandPressOn()
{
  this->PressedHere = false;
  this->Actors.hideMarker();
  if (auto* const style = vtkInteractorStyle::SafeDownCast(this->Interactor->GetInteractorStyle()))
  {
    style->OnLeftButtonDown();
  }
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::StartDrag()
{
  const Aim aim = this->AimAt(-1);
  CurveChoice node = aim.node;
  const bool insert = node.curve < 0 && aim.line.curve >= 0 && this->Interactor->GetControlKey();
  if (node.curve < 0 && !insert)
  {
    return false;
  }
  this->Editor->BeginGroup();
  if (insert)
  {
    node = { aim.line.curve, aim.line.node + 1 };
    const int kind = this->Editor->GetSegmentKind(aim.line.curve, aim.line.node);
    if (!this->Finished(this->Editor->InsertNode(node.curve, node.node, aim.point.data(), kind)))
    {
      this->Editor->EndGroup();
      return true;
    }
  }
  this->Choose(node.curve, node.node);
  this->State = Mode::Dragging;
  this->InvokeEvent(vtkCommand::StartInteractionEvent, nullptr);
  return true;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::OnMove()
{
  if (this->State == Mode::Dragging)
  {
    if (this->HasMoved())
    {
      const Aim aim = this->AimAt(this->Chosen.curve);
      if (aim.onSurface &&
        this->Finished(
          this->Editor->MoveNode(this->Chosen.curve, this->Chosen.node, aim.point.data())))
      {
        this->Pressed = { -2 * stillHand, -2 * stillHand }; // it has moved, wherever it goes now
        this->UpdateHint(aim);
        this->InvokeEvent(vtkCommand::InteractionEvent, nullptr);
      }
    }
    this->EventCallbackCommand->SetAbortFlag(1);
    this->Render();
    return;
  }
  if (this->PressedHere && this->HasMoved())
  {
    this->HandPressOn();
    return;
  }
  const Aim aim = this->AimAt(-1);
  this->Actors.hideMarker();
  if (aim.onSurface && this->State == Mode::Drawing)
  {
    this->Actors.drawMarker(aim.point, aim.snapped != 0);
  }
  else if (aim.node.curve >= 0)
  {
    std::array<double, 3> node;
    this->Editor->GetNode(aim.node.curve, aim.node.node, node.data());
    this->Actors.drawMarker(node, true);
  }
  this->UpdateHint(aim);
  this->Render();
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::OnRelease()
{
  const bool here = this->PressedHere;
  this->PressedHere = false;
  if (this->State == Mode::Dragging)
  {
    this->Editor->EndGroup();
    this->State = Mode::Choosing;
    this->EventCallbackCommand->SetAbortFlag(1);
    this->InvokeEvent(vtkCommand::EndInteractionEvent, nullptr);
    this->Render();
  }
  else if (here && !this->HasMoved())
  {
    this->OnClick();
    this->Render();
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::OnRightPress()
{
  if (this->State == Mode::Drawing)
  {
    this->Do(FINISH);
    this->EventCallbackCommand->SetAbortFlag(1);
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::OnClick()
{
  const Aim aim = this->AimAt(-1);
  const int curve = aim.node.curve >= 0 ? aim.node.curve : aim.line.curve;
  if (this->State == Mode::Drawing)
  {
    if (aim.onSurface)
    {
      this->AddNode(aim);
    }
  }
  else if (this->State == Mode::Joining)
  {
    this->State = Mode::Choosing;
    if (curve >= 0 && this->Finished(this->Editor->JoinCurves(this->Chosen.curve, curve)))
    {
      this->Choose(this->Chosen.curve - (curve < this->Chosen.curve ? 1 : 0), -1);
    }
  }
  else
  {
    this->Choose(curve, aim.node.curve >= 0 ? aim.node.node : -1);
  }
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::AddNode(const Aim& aim)
{
  const int count = this->Editor->GetNumberOfNodes(this->Chosen.curve);
  if (count == 0)
  {
    vtkNew<vtkPoints> nodes;
    nodes->SetDataTypeToDouble();
    nodes->InsertNextPoint(aim.point.data());
    const int curve = this->Editor->GetNumberOfCurves();
    const bool added = this->Finished(this->Editor->AddCurve(nodes));
    this->Choose(added ? curve : -1, added ? 0 : -1);
    return added;
  }
  if (aim.node == CurveChoice{ this->Chosen.curve, count - 1 })
  {
    return this->Do(FINISH);
  }
  if (aim.node == CurveChoice{ this->Chosen.curve, 0 } && count > 2)
  {
    return this->Finished(this->Editor->SetCurveClosed(this->Chosen.curve, true)) &&
      this->Do(FINISH);
  }
  const bool added = this->Finished(
    this->Editor->InsertNode(this->Chosen.curve, count, aim.point.data(), this->Kind));
  if (added)
  {
    this->Choose(this->Chosen.curve, count);
  }
  return added;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::Choose(int curve, int node)
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
  if (!done)
  {
    this->SetHint(this->Editor->GetMessage());
  }
  return done;
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
      typeNames[static_cast<std::size_t>(std::clamp(this->Editor->GetCurveType(curve), 0, 3))] +
      ", length " + shortNumber(this->Editor->GetCurveLength(curve)) + ", " +
      std::to_string(count) + (count == 1 ? " node. " : " nodes. ");
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
      label = length < 0.0 ? "no way there" : shortNumber(length) + " " + label;
    }
    words += count == 0 ? "Click where the curve starts."
                        : "Click to go on; Return or the right button ends the curve.";
  }
  else if (this->State == Mode::Choosing)
  {
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
