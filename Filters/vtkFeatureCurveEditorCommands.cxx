// SPDX-License-Identifier: BSD-3-Clause
// The commands of vtkFeatureCurveEditor.
#include "vtkFeatureCurveEditor.h"

#include "CurveEditorData.h"
#include "CurveEditorModel.h"
#include "RemedyWords.h"
#include "SurfaceInput.h"

#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <new>

using namespace flattening;
using bridge::clampedKind;
using bridge::idOf;
using bridge::isFinite;
using bridge::kindOf;
using bridge::pointOf;

namespace
{
const char* const noSurface = "there is no surface to draw on; give one by SetSurface()";
const char* const notFinite = "a point is not finite";

bool hasFinitePoints(vtkPoints* points)
{
  for (vtkIdType k = 0; points && k < points->GetNumberOfPoints(); ++k)
  {
    if (!isFinite(points->GetPoint(k)))
    {
      return false;
    }
  }
  return true;
}

std::vector<SurfacePoint> pointsOn(const DrawingSurface& surface, vtkPoints* points)
{
  std::vector<SurfacePoint> places;
  for (vtkIdType k = 0; points && k < points->GetNumberOfPoints(); ++k)
  {
    places.push_back(surface.pointNear(pointOf(points->GetPoint(k))));
  }
  return places;
}
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::Refuse(const std::string& message)
{
  this->Message = message;
  return false;
}

//------------------------------------------------------------------------------
template <typename Command>
bool vtkFeatureCurveEditor::Carry(const Command& command)
{
  if (!this->Drawn)
  {
    return this->Refuse(noSurface);
  }
  const Status status = command(this->Drawn->editor);
  this->Message = bridge::inWords(status);
  if (status.refused())
  {
    return false;
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetSurface(vtkPolyData* surface)
{
  if (!surface)
  {
    return this->Refuse(noSurface);
  }
  try
  {
    bridge::LoadedSurface loaded = bridge::loadSurface(surface, CoincidentPoints::Automatic);
    if (loaded.outcome.refused() || loaded.prepared.mesh.triangleCount() == 0)
    {
      return this->Refuse(bridge::inWords(loaded.outcome));
    }
    this->Drawn = std::make_unique<bridge::CurveEditorModel>(std::move(loaded.prepared.mesh));
  }
  catch (const std::bad_alloc&)
  {
    return this->Refuse("out of memory");
  }
  this->Message.clear();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetCurves(vtkPolyData* curves)
{
  if (!curves)
  {
    return this->Refuse("there are no curves");
  }
  std::string note;
  const bool done = this->Carry([&](CurveEditor& editor) {
    const bridge::CurveSetInput input = bridge::readCurveSet(curves, editor.surface());
    note = input.note;
    return input.status.ok() ? editor.restart(input.curves, input.mirror) : input.status;
  });
  this->Message = done && this->Message.empty() ? note : this->Message;
  return done;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::AddCurve(vtkPoints* nodes, int kind, bool closed)
{
  if (!hasFinitePoints(nodes))
  {
    return this->Refuse(notFinite);
  }
  return this->Carry([&](CurveEditor& editor) {
    EditedCurve curve;
    curve.nodes = pointsOn(editor.surface(), nodes);
    curve.closed = closed;
    curve.kinds.assign(segmentCount(curve.nodes.size(), curve.closed), kindOf(kind));
    return editor.add(std::move(curve));
  });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::RemoveCurve(int curve)
{
  return this->Carry([=](CurveEditor& editor) { return editor.remove(idOf(curve)); });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::AddOffset(int curve, double distance)
{
  return this->Carry([=](CurveEditor& editor) { return editor.addOffset(idOf(curve), distance); });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::TightenCurve(int curve)
{
  return this->Carry([=](CurveEditor& editor) { return editor.tighten(idOf(curve)); });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::AddStroke(vtkPoints* stroke, double tolerance, int kind)
{
  if (!hasFinitePoints(stroke))
  {
    return this->Refuse(notFinite);
  }
  return this->Carry([=](CurveEditor& editor) {
    return editor.addStroke(pointsOn(editor.surface(), stroke), tolerance, kindOf(kind));
  });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::InsertNode(int curve, int node, const double point[3], int kind)
{
  if (!isFinite(point))
  {
    return this->Refuse(notFinite);
  }
  return this->Carry([=](CurveEditor& editor) {
    return editor.insertNode(
      idOf(curve), idOf(node), editor.surface().pointNear(pointOf(point)), kindOf(kind));
  });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::MoveNode(int curve, int node, const double point[3])
{
  if (!isFinite(point))
  {
    return this->Refuse(notFinite);
  }
  return this->Carry([=](CurveEditor& editor) {
    return editor.moveNode(idOf(curve), idOf(node), editor.surface().pointNear(pointOf(point)));
  });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::RemoveNode(int curve, int node)
{
  return this->Carry(
    [=](CurveEditor& editor) { return editor.removeNode(idOf(curve), idOf(node)); });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetCurveClosed(int curve, bool closed)
{
  return this->Carry([=](CurveEditor& editor) { return editor.setClosed(idOf(curve), closed); });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SplitCurve(int curve, int node)
{
  return this->Carry([=](CurveEditor& editor) { return editor.split(idOf(curve), idOf(node)); });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::JoinCurves(int first, int second)
{
  return this->Carry([=](CurveEditor& editor) { return editor.join(idOf(first), idOf(second)); });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::AddMirrorImage(int curve)
{
  return this->Carry([=](CurveEditor& editor) { return editor.addImage(idOf(curve)); });
}

//------------------------------------------------------------------------------
template <typename Change>
bool vtkFeatureCurveEditor::Describe(int curve, const Change& change)
{
  return this->Carry([&](CurveEditor& editor) {
    CurveTraits traits;
    if (const EditedCurve* const found = this->Drawn->curve(curve))
    {
      traits = found->traits;
    }
    change(traits);
    return editor.describe(idOf(curve), traits);
  });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetCurveName(int curve, const std::string& name)
{
  return this->Describe(curve, [&](CurveTraits& traits) { traits.name = name; });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetCurveType(int curve, int type)
{
  return this->Describe(
    curve, [=](CurveTraits& traits) { traits.type = clampedKind(CurveType::Seam, type); });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetCurveKeyShape(int curve, int shape)
{
  return this->Describe(
    curve, [=](CurveTraits& traits) { traits.keyShape = clampedKind(KeyShape::Straight, shape); });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetCurveTolerance(int curve, double tolerance)
{
  return this->Describe(curve, [=](CurveTraits& traits) { traits.tolerance = tolerance; });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetCurveEase(int curve, double fraction, int piece)
{
  return this->Describe(curve, [=](CurveTraits& traits) { traits.ease = { fraction, piece }; });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetCurveMirrored(int curve, bool mirrored)
{
  return this->Describe(curve, [=](CurveTraits& traits) { traits.mirrored = mirrored; });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetSegmentKind(int curve, int segment, int kind)
{
  return this->Carry(
    [=](CurveEditor& editor) { return editor.setKind(idOf(curve), idOf(segment), kindOf(kind)); });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::SetMirrorPlane(const double origin[3], const double normal[3])
{
  const double length = vtkMath::Norm(normal);
  if (!isFinite(origin) || !isFinite(normal) || !(length > 0.0))
  {
    return this->Refuse("a mirror plane has a finite origin, and a normal with a length");
  }
  return this->Carry([=](CurveEditor& editor) {
    return editor.setMirror(MirrorPlane{ pointOf(origin), pointOf(normal) / length });
  });
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::RemoveMirrorPlane()
{
  return this->Carry([](CurveEditor& editor) { return editor.setMirror({}); });
}

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::Undo()
{
  if (this->CanUndo())
  {
    this->Drawn->editor.undo();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::Redo()
{
  if (this->CanRedo())
  {
    this->Drawn->editor.redo();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::BeginGroup()
{
  if (this->Drawn)
  {
    this->Drawn->editor.beginGroup();
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::EndGroup()
{
  if (this->Drawn)
  {
    this->Drawn->editor.endGroup();
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::JoinCommandsSince(int count)
{
  if (this->Drawn)
  {
    this->Drawn->editor.joinSince(static_cast<std::size_t>(std::max(count, 0)));
  }
}
