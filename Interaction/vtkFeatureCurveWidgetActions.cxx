// SPDX-License-Identifier: BSD-3-Clause
// What can be done apart from clicks: the actions of vtkFeatureCurveWidget.
#include "vtkFeatureCurveWidget.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkFeatureCurveAlgorithm.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>

namespace
{
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
  this->Render();
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
    symmetry = this->Picker.symmetry();
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
  std::string key = std::string(this->Interactor->GetControlKey() ? "Control-" : "") + symbol;
  key = key == "Escape" ? GetActionKey(FINISH) : key;
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
bool vtkFeatureCurveWidget::MakeGirth()
{
  this->EndDrawing();
  const int curve = this->Chosen.curve;
  this->Editor->BeginGroup();
  bool done = true;
  for (int k = 0; k < this->Editor->GetNumberOfSegments(curve) && done; ++k)
  {
    done = this->Editor->SetSegmentKind(curve, k, vtkFeatureCurveEditor::SECTION);
  }
  done = done && this->Editor->SetCurveClosed(curve, true);
  this->Editor->EndGroup();
  return this->Finished(done);
}
