// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveWidget.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkFeatureCurveAlgorithm.h>
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

struct Action
{
  const char* name;
  const char* key;
};

constexpr std::array<Action, vtkFeatureCurveWidget::NUMBER_OF_ACTIONS> actions{ {
  { "New curve", "n" },
  { "End curve", "Return" },
  { "Remove node", "BackSpace" },
  { "Remove curve", "Delete" },
  { "Closed", "c" },
  { "Split at node", "x" },
  { "Join with the next curve clicked", "j" },
  { "Mirrored", "m" },
  { "Accessory: keeps its length", "a" },
  { "Key: keeps its shape as well", "k" },
  { "Dart: cut open", "d" },
  { "Seam: separates pieces", "s" },
  { "Straight in the plane", "t" },
  { "Straight over the surface", "g" },
  { "Plane section", "p" },
  { "Snap (Alt: not now)", "F3" },
  { "Undo", "Control-z" },
  { "Redo", "Control-y" },
} };

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
const char* vtkFeatureCurveWidget::GetActionName(int action)
{
  return action >= 0 && action < NUMBER_OF_ACTIONS ? actions[static_cast<std::size_t>(action)].name
                                                   : "";
}

//------------------------------------------------------------------------------
const char* vtkFeatureCurveWidget::GetActionKey(int action)
{
  return action >= 0 && action < NUMBER_OF_ACTIONS ? actions[static_cast<std::size_t>(action)].key
                                                   : "";
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::CanDo(int action) const
{
  const bool drawing = this->State == Mode::Drawing;
  const int nodes = this->Editor ? this->Editor->GetNumberOfNodes(this->Chosen.curve) : 0;
  switch (action)
  {
    case NEW_CURVE:
    case GEODESIC:
    case SECTION:
    case SNAP:
      return this->Editor != nullptr;
    case FINISH:
      return drawing;
    case REMOVE_NODE:
      return nodes > 0 && (drawing || this->Chosen.node >= 0);
    case CLOSE:
      return nodes > 2 || (this->Editor && this->Editor->GetCurveClosed(this->Chosen.curve));
    case SPLIT:
      return !drawing && this->Chosen.node >= 0 &&
        (this->Editor->GetCurveClosed(this->Chosen.curve) ||
          (this->Chosen.node > 0 && this->Chosen.node < nodes - 1));
    case JOIN:
      return !drawing && nodes > 0 && this->Editor->GetNumberOfCurves() > 1;
    case STRAIGHT_KEY:
      return nodes > 0 &&
        this->Editor->GetCurveType(this->Chosen.curve) == vtkFeatureCurveAlgorithm::KEY;
    case UNDO:
      return this->Editor && this->Editor->CanUndo();
    case REDO:
      return this->Editor && this->Editor->CanRedo();
    default:
      return nodes > 0;
  }
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::IsOn(int action) const
{
  if (action == SNAP)
  {
    return this->Snapping;
  }
  if (!this->Editor)
  {
    return false;
  }
  const int curve = this->Chosen.curve;
  const bool chosen = curve >= 0;
  const int kind =
    chosen && this->State != Mode::Drawing ? this->Editor->GetSegmentKind(curve, 0) : this->Kind;
  switch (action)
  {
    case NEW_CURVE:
      return this->State == Mode::Drawing;
    case JOIN:
      return this->State == Mode::Joining;
    case CLOSE:
      return this->Editor->GetCurveClosed(curve);
    case MIRROR:
      return this->Editor->GetCurveMirrored(curve);
    case STRAIGHT_KEY:
      return this->Editor->GetCurveKeyShape(curve) != 0;
    case GEODESIC:
    case SECTION:
      return kind == action - GEODESIC;
    case MAKE_ACCESSORY:
    case MAKE_KEY:
    case MAKE_DART:
    case MAKE_SEAM:
      return chosen && this->Editor->GetCurveType(curve) == action - MAKE_ACCESSORY;
    default:
      return false;
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
bool vtkFeatureCurveWidget::Do(int action)
{
  if (!this->CanDo(action))
  {
    return false;
  }
  const int curve = this->Chosen.curve;
  bool done = true;
  switch (action)
  {
    case NEW_CURVE:
      this->State = Mode::Drawing;
      this->Choose(-1, -1);
      break;
    case FINISH:
      this->State = Mode::Choosing;
      if (this->Editor->GetNumberOfNodes(curve) == 1)
      {
        this->Editor->RemoveCurve(curve);
        this->Choose(-1, -1);
      }
      this->Choose(this->Chosen.curve, -1);
      break;
    case REMOVE_NODE:
      done = this->StepBack();
      break;
    case REMOVE_CURVE:
      this->State = Mode::Choosing;
      done = this->Finished(this->Editor->RemoveCurve(curve));
      this->Choose(-1, -1);
      break;
    case CLOSE:
      done =
        this->Finished(this->Editor->SetCurveClosed(curve, !this->Editor->GetCurveClosed(curve)));
      break;
    case SPLIT:
      done = this->Finished(this->Editor->SplitCurve(curve, this->Chosen.node));
      this->Choose(curve, -1);
      break;
    case JOIN:
      this->State = Mode::Joining;
      this->SetHint("click the curve to join with");
      break;
    case MIRROR:
      done = this->ToggleMirror();
      break;
    case STRAIGHT_KEY:
      done = this->Finished(
        this->Editor->SetCurveKeyShape(curve, 1 - this->Editor->GetCurveKeyShape(curve)));
      break;
    case GEODESIC:
    case SECTION:
      done = this->SetKind(action - GEODESIC);
      break;
    case SNAP:
      this->Snapping = !this->Snapping;
      break;
    case UNDO:
      this->Editor->Undo();
      break;
    case REDO:
      this->Editor->Redo();
      break;
    default:
      done = this->Finished(this->Editor->SetCurveType(curve, action - MAKE_ACCESSORY));
  }
  if (done && action != JOIN)
  {
    this->UpdateHint({});
  }
  this->Render();
  return done;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::StepBack()
{
  const int curve = this->Chosen.curve;
  const int last = this->Editor->GetNumberOfNodes(curve) - 1;
  const bool drawing = this->State == Mode::Drawing;
  const bool done =
    this->Finished(this->Editor->RemoveNode(curve, drawing ? last : this->Chosen.node));
  if (done && last == 0)
  {
    this->Choose(-1, -1);
  }
  else if (done)
  {
    this->Choose(curve, drawing ? last - 1 : -1);
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::ToggleMirror()
{
  const int curve = this->Chosen.curve;
  this->Editor->BeginGroup();
  bool done = true;
  if (!this->Editor->HasMirrorPlane())
  {
    const interaction::Symmetry symmetry = this->Picker.symmetry();
    done = this->Editor->SetMirrorPlane(symmetry.origin.data(), symmetry.normal.data());
  }
  done = done && this->Editor->SetCurveMirrored(curve, !this->Editor->GetCurveMirrored(curve));
  this->Editor->EndGroup();
  return this->Finished(done);
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::SetKind(int kind)
{
  this->Kind = kind;
  if (this->State == Mode::Drawing)
  {
    return true;
  }
  const int curve = this->Chosen.curve;
  bool done = true;
  this->Editor->BeginGroup();
  for (int k = 0; k < this->Editor->GetNumberOfSegments(curve) && done; ++k)
  {
    done = this->Editor->SetSegmentKind(curve, k, kind);
  }
  this->Editor->EndGroup();
  return this->Finished(done);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::OnKey()
{
  const char* const symbol = this->Interactor->GetKeySym();
  if (!this->HandleKeys || !symbol)
  {
    return;
  }
  const std::string key = std::string(this->Interactor->GetControlKey() ? "Control-" : "") + symbol;
  for (int action = 0; action < NUMBER_OF_ACTIONS; ++action)
  {
    if (key == GetActionKey(action))
    {
      // A key comes as two events; the style must see neither.
      if (this->CurrentEvent == vtkCommand::KeyPressEvent)
      {
        this->Do(action);
      }
      this->EventCallbackCommand->SetAbortFlag(1);
      return;
    }
  }
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
