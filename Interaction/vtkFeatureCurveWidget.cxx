// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveWidget.h"

#include "SurfacePicker.h"
#include "vtkFeatureCurveRepresentation.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkEvent.h>
#include <vtkFeatureCurveAlgorithm.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkInteractorStyle.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetCallbackMapper.h>
#include <vtkWidgetEvent.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace interaction = flattening::interaction;

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

constexpr int stillHand = 3; // pixels that a click may move

/// Of interaction::Symmetry::error; a shirt front that is sewn by hand has less.
constexpr double fairlySymmetric = 0.1;

struct Action
{
  const char* name;
  const char* key;
};

constexpr std::array<Action, vtkFeatureCurveWidget::NUMBER_OF_ACTIONS> actions{ {
  { "New curve", "n" },
  { "New curve by a stroke", "f" },
  { "End curve", "Return" },
  { "Remove node", "BackSpace" },
  { "Remove curve", "Delete" },
  { "Closed", "c" },
  { "Pull tight round the surface", "u" },
  { "Split at node", "x" },
  { "Join with the next curve clicked", "j" },
  { "Offset through the next place clicked", "l" },
  { "Mirrored", "m" },
  { "Accessory: keeps its length", "a" },
  { "Key: keeps its shape as well", "k" },
  { "Dart: cut open", "d" },
  { "Seam: separates pieces", "s" },
  { "Straight in the plane", "t" },
  { "Straight over the surface", "g" },
  { "Plane section", "p" },
  { "Along edges of the mesh", "e" },
  { "Smooth through all nodes", "b" },
  { "Girth through two or three nodes", "o" },
  { "Snap (Alt: not now)", "F3" },
  { "Undo", "Control-z" },
  { "Redo", "Control-y" },
} };
}

//------------------------------------------------------------------------------
struct vtkFeatureCurveWidget::Aim
{
  bool onSurface = false;
  std::array<double, 3> point{}; ///< where a node would come
  std::array<double, 3> seen{};  ///< under the mouse itself
  double pixel = 0.0;            ///< its length there
  int snapped = 0;               ///< vtkFeatureCurveEditor::SnapTargets
  Choice node;                   ///< under the mouse
  Choice line;                   ///< under the mouse; node: the segment
};

//------------------------------------------------------------------------------
template <void (vtkFeatureCurveWidget::*Method)()>
void vtkFeatureCurveWidget::Answer(vtkAbstractWidget* widget)
{
  auto* const self = static_cast<vtkFeatureCurveWidget*>(widget);
  if (self->Editor)
  {
    (self->*Method)();
  }
}

//------------------------------------------------------------------------------
vtkFeatureCurveWidget::vtkFeatureCurveWidget()
  : Picker(std::make_unique<interaction::SurfacePicker>())
{
  using Self = vtkFeatureCurveWidget;
  this->ManagesCursor = 0;
  this->KeyPressActivationOff();
  vtkWidgetCallbackMapper* const mapper = this->CallbackMapper;
  mapper->SetCallbackMethod(
    vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this, &Self::Answer<&Self::OnPress>);
  mapper->SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this,
    &Self::Answer<&Self::OnRelease>);
  mapper->SetCallbackMethod(vtkCommand::LeftButtonDoubleClickEvent, vtkWidgetEvent::Completed, this,
    &Self::Answer<&Self::OnDoubleClick>);
  mapper->SetCallbackMethod(vtkCommand::RightButtonPressEvent, vtkWidgetEvent::AddFinalPoint, this,
    &Self::Answer<&Self::OnRightPress>);
  mapper->SetCallbackMethod(
    vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, &Self::Answer<&Self::OnMove>);
  mapper->SetCallbackMethod(
    vtkCommand::KeyPressEvent, vtkWidgetEvent::ModifyEvent, this, &Self::Answer<&Self::OnKeyPress>);
  // A key comes as two events, which VTK has no second meaning for.
  mapper->SetCallbackMethod(
    vtkCommand::CharEvent, vtkWidgetEvent::Reset, this, &Self::Answer<&Self::OnChar>);
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
void vtkFeatureCurveWidget::SetRepresentation(vtkFeatureCurveRepresentation* representation)
{
  this->SetWidgetRepresentation(representation);
  if (representation)
  {
    representation->SetEditor(this->Editor);
    this->Redraw();
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
  {
    vtkNew<vtkFeatureCurveRepresentation> representation;
    this->SetRepresentation(representation);
  }
}

//------------------------------------------------------------------------------
vtkFeatureCurveRepresentation* vtkFeatureCurveWidget::Drawn()
{
  return static_cast<vtkFeatureCurveRepresentation*>(this->GetRepresentation());
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::SetEditor(vtkFeatureCurveEditor* editor)
{
  if (this->Editor)
  {
    this->Editor->RemoveObserver(this->EditorTag);
  }
  this->Editor = editor;
  this->Drawn()->SetEditor(editor);
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
  this->Picker->setSurface(surface);
  this->State = Mode::Choosing;
  this->Choose(-1, -1);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::SetEnabled(int enabled)
{
  const bool was = this->Enabled != 0;
  if (was && !enabled && this->CurveRenderer)
  {
    this->CurveRenderer->RemoveViewProp(this->WidgetRep);
  }
  this->Superclass::SetEnabled(enabled);
  if (this->Enabled && !was)
  {
    if (this->CurveRenderer)
    {
      this->CurrentRenderer->RemoveViewProp(this->WidgetRep);
      this->CurveRenderer->AddViewProp(this->WidgetRep);
      this->WidgetRep->SetRenderer(this->CurveRenderer);
    }
    this->Redraw();
  }
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
  const Choice chosen{ curve, curve < 0 ? -1 : node };
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
  this->Drawn()->HideMarker();
  this->Drawn()->SetChosen(this->Chosen.curve, this->Chosen.node);
  this->Drawn()->BuildRepresentation();
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::RenderIfEnabled()
{
  if (this->Enabled)
  {
    this->Render();
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
      vtkFeatureCurveRepresentation::GetTypeName(this->Editor->GetCurveType(curve)) + ", " +
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
      const double length = this->Editor->PreviewSegment(
        last, aim.point.data(), this->Kind, this->Drawn()->GetPreview());
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
    this->Drawn()->DrawLabel(label, pixel[0], pixel[1]);
  }
  this->SetHint(words);
}

//------------------------------------------------------------------------------
vtkFeatureCurveWidget::Aim vtkFeatureCurveWidget::AimAt(int exceptCurve) const
{
  Aim aim;
  const int* const position = this->Interactor->GetEventPosition();
  const std::array<int, 2> pixel{ position[0], position[1] };
  interaction::SurfacePick picked;
  if (!this->CurrentRenderer->IsInViewport(pixel[0], pixel[1]) ||
    !this->Picker->pick(this->CurrentRenderer, pixel, this->Reach, picked))
  {
    return aim;
  }
  aim.onSurface = true;
  const double reach = this->Reach * picked.pixel;
  aim.seen = picked.point;
  aim.pixel = picked.pixel;
  const double* const point = picked.point.data();
  double view[3];
  this->CurrentRenderer->GetActiveCamera()->GetDirectionOfProjection(view);
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
  this->PressedHere = this->CurrentRenderer->IsInViewport(position[0], position[1]) != 0;
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
  this->Drawn()->HideMarker();
  if (auto* const style = vtkInteractorStyle::SafeDownCast(this->Interactor->GetInteractorStyle()))
  {
    style->OnLeftButtonDown();
  }
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::StartDrag()
{
  const Aim aim = this->AimAt(-1);
  Choice node = aim.node;
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
void vtkFeatureCurveWidget::FinishStroke()
{
  // Its ends snap, as nodes do.
  const Aim aim = this->AimAt(-1);
  if (aim.onSurface)
  {
    this->Stroke->InsertNextPoint(aim.point.data());
  }
  this->State = Mode::Choosing;
  this->Drawn()->HideMarker();
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
    this->RenderIfEnabled();
    return;
  }
  if (this->State == Mode::Stroking)
  {
    const Aim aim = this->AimAt(-1);
    if (aim.onSurface)
    {
      this->Stroke->InsertNextPoint(aim.seen.data());
      this->Drawn()->DrawStroke(this->Stroke);
    }
    this->EventCallbackCommand->SetAbortFlag(1);
    this->RenderIfEnabled();
    return;
  }
  if (this->PressedHere && this->HasMoved())
  {
    this->HandPressOn();
    return;
  }
  const Aim aim = this->AimAt(-1);
  this->Drawn()->HideMarker();
  if (aim.onSurface && this->IsPlacing())
  {
    this->Drawn()->DrawMarker(aim.point.data(), aim.snapped != 0);
  }
  else if (aim.node.curve >= 0)
  {
    std::array<double, 3> node;
    this->Editor->GetNode(aim.node.curve, aim.node.node, node.data());
    this->Drawn()->DrawMarker(node.data(), true);
  }
  this->UpdateHint(aim);
  this->RenderIfEnabled();
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::OnRelease()
{
  const bool here = this->PressedHere;
  this->PressedHere = false;
  if (this->State == Mode::Dragging || this->State == Mode::Stroking)
  {
    this->State == Mode::Dragging ? this->EndDrag() : this->FinishStroke();
    this->EventCallbackCommand->SetAbortFlag(1);
    this->RenderIfEnabled();
  }
  else if (here && !this->HasMoved())
  {
    this->OnClick();
    this->RenderIfEnabled();
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
  if (this->IsPlacing() && !aim.onSurface)
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
  if (aim.node == Choice{ this->Chosen.curve, count - 1 })
  {
    return this->Do(FINISH);
  }
  if (aim.node == Choice{ this->Chosen.curve, 0 } && count > 2)
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
    case FREEHAND:
    case GEODESIC:
    case SECTION:
    case EDGES:
    case SPLINE:
    case SNAP:
      return this->Editor != nullptr;
    case FINISH:
      return this->State != Mode::Choosing && this->State != Mode::Dragging;
    case REMOVE_NODE:
      return nodes > 0 && (drawing || this->Chosen.node >= 0);
    case CLOSE:
      return nodes > 2 || (this->Editor && this->Editor->GetCurveClosed(this->Chosen.curve));
    case TIGHTEN:
      return !drawing && this->Editor && this->Editor->GetCurveClosed(this->Chosen.curve);
    case SPLIT:
      return !drawing && this->Chosen.node >= 0 &&
        (this->Editor->GetCurveClosed(this->Chosen.curve) ||
          (this->Chosen.node > 0 && this->Chosen.node < nodes - 1));
    case JOIN:
      return !drawing && nodes > 0 && this->Editor->GetNumberOfCurves() > 1;
    case OFFSET:
      return !drawing && nodes > 1;
    case GIRTH:
      return (nodes == 2 || nodes == 3) && !this->Editor->GetCurveClosed(this->Chosen.curve);
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
    case FREEHAND:
      return this->State == Mode::Sketching || this->State == Mode::Stroking;
    case JOIN:
      return this->State == Mode::Joining;
    case OFFSET:
      return this->State == Mode::Offsetting;
    case CLOSE:
      return this->Editor->GetCurveClosed(curve);
    case MIRROR:
      return this->Editor->GetCurveMirrored(curve);
    case STRAIGHT_KEY:
      return this->Editor->GetCurveKeyShape(curve) != 0;
    case GEODESIC:
    case SECTION:
    case EDGES:
    case SPLINE:
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
bool vtkFeatureCurveWidget::Do(int action)
{
  if (!this->CanDo(action))
  {
    return false;
  }
  if (action != SNAP)
  {
    this->EndDrag(); // its group would take in all that comes after
    this->Missed = false;
  }
  const int curve = this->Chosen.curve;
  bool done = true;
  switch (action)
  {
    case NEW_CURVE:
      this->EndDrawing();
      this->State = Mode::Drawing;
      this->DrawnSince = this->Editor->GetNumberOfCommands();
      this->Select(-1, -1);
      break;
    case FREEHAND:
      this->EndDrawing();
      this->State = Mode::Sketching;
      this->Select(-1, -1);
      break;
    case FINISH:
      done = this->EndDrawing();
      break;
    case REMOVE_NODE:
      done = this->StepBack();
      break;
    case REMOVE_CURVE:
      if (this->State == Mode::Drawing)
      {
        this->Editor->JoinCommandsSince(this->DrawnSince);
      }
      this->State = Mode::Choosing;
      done = this->Finished(this->Editor->RemoveCurve(curve));
      this->Select(-1, -1);
      break;
    case CLOSE:
      done =
        this->Finished(this->Editor->SetCurveClosed(curve, !this->Editor->GetCurveClosed(curve)));
      done = done && (this->State != Mode::Drawing || this->EndDrawing());
      break;
    case TIGHTEN:
      done = this->Finished(this->Editor->TightenCurve(curve));
      this->Select(curve, -1);
      break;
    case SPLIT:
      done = this->Finished(this->Editor->SplitCurve(curve, this->Chosen.node));
      this->Select(curve, -1);
      break;
    case JOIN:
      this->State = Mode::Joining;
      this->SetHint("click the curve to join with");
      break;
    case OFFSET:
      this->State = Mode::Offsetting;
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
    case EDGES:
    case SPLINE:
      done = this->SetKind(action - GEODESIC);
      break;
    case GIRTH:
      done = this->MakeGirth();
      break;
    case SNAP:
      this->Snapping = !this->Snapping;
      break;
    case UNDO:
    case REDO:
      this->UndoOrRedo(action);
      break;
    default:
      done = this->Finished(this->Editor->SetCurveType(curve, action - MAKE_ACCESSORY));
  }
  if (done && action != JOIN)
  {
    this->UpdateHint({});
  }
  this->RenderIfEnabled();
  return done;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::EndDrawing()
{
  const int curve = this->Chosen.curve;
  const bool drawing = this->State == Mode::Drawing;
  const bool kept = !drawing || this->Editor->GetNumberOfNodes(curve) != 1;
  const std::string name = this->Editor->GetCurveName(curve);
  this->State = Mode::Choosing;
  if (!kept)
  {
    this->Editor->RemoveCurve(curve);
  }
  if (drawing)
  {
    this->Editor->JoinCommandsSince(this->DrawnSince);
  }
  this->Select(kept ? curve : -1, -1);
  return kept || this->Refuse("'" + name + "' has one node and is not kept; a curve needs two");
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::UndoOrRedo(int action)
{
  action == UNDO ? this->Editor->Undo() : this->Editor->Redo();
  const int commands = this->Editor->GetNumberOfCommands();
  if (this->State == Mode::Drawing)
  {
    this->DrawnSince = std::min(this->DrawnSince, commands);
    return;
  }
  // A curve of one node is one that was being drawn.
  for (int curve = 0; curve < this->Editor->GetNumberOfCurves(); ++curve)
  {
    if (this->Editor->GetNumberOfNodes(curve) == 1)
    {
      this->State = Mode::Drawing;
      this->DrawnSince = std::max(commands - 1, 0);
      this->Select(curve, 0);
    }
  }
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
    this->Select(-1, -1);
  }
  else if (done)
  {
    this->Select(curve, drawing ? last - 1 : -1);
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::ToggleMirror()
{
  const int curve = this->Chosen.curve;
  this->Editor->BeginGroup();
  bool done = true;
  interaction::Symmetry symmetry;
  if (!this->Editor->HasMirrorPlane())
  {
    symmetry = this->Picker->symmetry();
    done = this->Editor->SetMirrorPlane(symmetry.origin.data(), symmetry.normal.data());
  }
  done = done && this->Editor->SetCurveMirrored(curve, !this->Editor->GetCurveMirrored(curve));
  this->Editor->EndGroup();
  if (done && symmetry.error > fairlySymmetric)
  {
    std::string words = "mirrored in the plane in which the surface is most like its image, but "
                        "it is not symmetric; Undo takes that back";
    this->InvokeEvent(vtkCommand::WarningEvent, words.data());
  }
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
  this->Editor->BeginGroup();
  const bool done = this->SetKindOfSegments(kind);
  this->Editor->EndGroup();
  return this->Finished(done);
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::SetKindOfSegments(int kind)
{
  bool done = true;
  for (int k = 0; k < this->Editor->GetNumberOfSegments(this->Chosen.curve) && done; ++k)
  {
    done = this->Editor->SetSegmentKind(this->Chosen.curve, k, kind);
  }
  return done;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::OnDoubleClick()
{
  this->Do(FINISH);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveWidget::ActionOfKey() const
{
  const char* const symbol = this->Interactor->GetKeySym();
  if (!this->HandleKeys || !symbol)
  {
    return -1;
  }
  std::string key = std::string(this->Interactor->GetControlKey() ? "Control-" : "") + symbol;
  key = key == "Escape" ? GetActionKey(FINISH) : key;
  for (int action = 0; action < NUMBER_OF_ACTIONS; ++action)
  {
    if (key == GetActionKey(action))
    {
      return action;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::OnKeyPress()
{
  const int action = this->ActionOfKey();
  if (action >= 0)
  {
    this->Do(action);
    this->EventCallbackCommand->SetAbortFlag(1);
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveWidget::OnChar()
{
  // The style must not see the second event of a key either.
  if (this->ActionOfKey() >= 0)
  {
    this->EventCallbackCommand->SetAbortFlag(1);
  }
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveWidget::MakeGirth()
{
  this->EndDrawing();
  this->Editor->BeginGroup();
  const bool done = this->SetKindOfSegments(vtkFeatureCurveEditor::SECTION) &&
    this->Editor->SetCurveClosed(this->Chosen.curve, true);
  this->Editor->EndGroup();
  return this->Finished(done);
}
