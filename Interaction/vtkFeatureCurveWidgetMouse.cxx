// SPDX-License-Identifier: BSD-3-Clause
// What the mouse does: the clicks and drags of vtkFeatureCurveWidget.
#include "vtkFeatureCurveWidget.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkInteractorStyle.h>
#include <vtkPoints.h>
#include <vtkRenderWindowInteractor.h>

#include <cstdlib>

using interaction::CurveChoice;

namespace
{
constexpr int stillHand = 3; // pixels that a click may move
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
  aim.seen = picked.point;
  aim.pixel = picked.pixel;
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
    else if (this->State == Mode::Sketching)
    {
      this->StartStroke();
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
  this->Select(node.curve, node.node);
  this->State = Mode::Dragging;
  this->InvokeEvent(vtkCommand::StartInteractionEvent, nullptr);
  return true;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::EndDrag()
{
  if (this->State == Mode::Dragging)
  {
    this->Editor->EndGroup();
    this->State = Mode::Choosing;
    this->PressedHere = false;
    this->InvokeEvent(vtkCommand::EndInteractionEvent, nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::StartStroke()
{
  const Aim aim = this->AimAt(-1);
  if (aim.onSurface)
  {
    this->Stroke->SetDataTypeToDouble();
    this->Stroke->Initialize();
    this->Stroke->InsertNextPoint(aim.point.data());
    this->StrokePixel = aim.pixel;
    this->State = Mode::Stroking;
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::GoOnStroke(const Aim& aim)
{
  if (aim.onSurface)
  {
    this->Stroke->InsertNextPoint(aim.seen.data());
    this->Actors.drawStroke(this->Stroke);
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::FinishStroke()
{
  // Its ends snap, as nodes do.
  const Aim aim = this->AimAt(-1);
  if (aim.onSurface)
  {
    this->Stroke->InsertNextPoint(aim.point.data());
  }
  this->State = Mode::Choosing;
  this->Actors.hideMarker();
  const int count = this->Editor->GetNumberOfCurves();
  if (this->Finished(
        this->Editor->AddStroke(this->Stroke, this->StrokeTolerance * this->StrokePixel)))
  {
    this->Select(count, -1);
  }
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
  if (this->State == Mode::Stroking)
  {
    this->GoOnStroke(this->AimAt(-1));
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
  const bool placing = this->State == Mode::Drawing || this->State == Mode::Sketching ||
    this->State == Mode::Offsetting;
  if (aim.onSurface && placing)
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
    this->EndDrag();
    this->EventCallbackCommand->SetAbortFlag(1);
    this->Render();
  }
  else if (this->State == Mode::Stroking)
  {
    this->FinishStroke();
    this->EventCallbackCommand->SetAbortFlag(1);
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
  if (this->CanDo(FINISH))
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
  const bool placing = this->State == Mode::Drawing || this->State == Mode::Sketching ||
    this->State == Mode::Offsetting;
  if (placing && !aim.onSurface)
  {
    this->Refuse("there is no surface under the mouse; click on it, or end with Return");
  }
  else if (this->State == Mode::Drawing)
  {
    this->AddNode(aim);
  }
  else if (this->State == Mode::Offsetting)
  {
    const int count = this->Editor->GetNumberOfCurves();
    if (this->Finished(this->Editor->AddOffset(
          this->Chosen.curve, this->Editor->GetDistance(this->Chosen.curve, aim.point.data()))))
    {
      this->State = Mode::Choosing;
      this->Select(count, -1);
    }
  }
  else if (this->State == Mode::Joining)
  {
    this->State = Mode::Choosing;
    if (curve < 0)
    {
      this->Refuse("there is no curve under the mouse; nothing is joined");
    }
    else if (this->Finished(this->Editor->JoinCurves(this->Chosen.curve, curve)))
    {
      this->Select(this->Chosen.curve - (curve < this->Chosen.curve ? 1 : 0), -1);
    }
  }
  else
  {
    this->Select(curve, aim.node.curve >= 0 ? aim.node.node : -1);
    this->Missed = curve < 0 && aim.onSurface;
    this->UpdateHint(aim);
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
    this->Select(added ? curve : -1, added ? 0 : -1);
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
    this->Select(this->Chosen.curve, count);
  }
  return added;
}
