// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveEditor.h"

#include "Base/Types.h"
#include "CurveEditorData.h"
#include "Editing/CurveDrawing.h"
#include "Editing/CurveEditor.h"
#include "Editing/CurveSnapping.h"
#include "Input/StatusWords.h"
#include "Paths/PathDistance.h"
#include "SurfaceInput.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>

namespace flattening::bridge
{
/// What is behind a vtkFeatureCurveEditor with a surface.
class CurveEditorModel
{
public:
  explicit CurveEditorModel(const std::shared_ptr<const DrawingSurface>& surface)
    : editor(surface)
    , preview(surface)
  {
  }

  CurveEditor editor;
  SegmentPreview preview;
};
}

using namespace flattening;

vtkStandardNewMacro(vtkFeatureCurveEditor);

namespace
{
Point3 pointOf(const double point[3])
{
  return { point[0], point[1], point[2] };
}

bool isFinite(const double point[3])
{
  return flattening::isFinite(pointOf(point));
}

template <typename Value>
Value clampedKind(Value last, int kind)
{
  return static_cast<Value>(std::clamp(kind, 0, static_cast<int>(last)));
}

SegmentKind kindOf(int kind)
{
  return clampedKind(SegmentKind::Spline, kind);
}

/// An id of Core; one that does not exist stays so.
std::size_t idOf(int id)
{
  return static_cast<std::size_t>(id);
}

/// Without nodes where there is none of the number.
const EditedCurve& curveOf(const bridge::CurveEditorModel* drawn, int curve)
{
  static const EditedCurve empty;
  return drawn && idOf(curve) < drawn->editor.curveCount() ? drawn->editor.curve(idOf(curve))
                                                           : empty;
}

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

double distanceTo(const SurfacePath& path, const SightMetric& sight, const Point3& point)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < path.points.size(); ++k)
  {
    const Point3& a = path.points[k - 1].position;
    const Point3& b = path.points[k].position;
    const Point3 nearest = a + sight.nearestFraction(a, b, point) * (b - a);
    least = std::min(least, sight.distance(nearest, point));
  }
  return least;
}

/// The curve and the part of it, a node or segment, at the least distance below a reach.
template <class Part, class Distance>
bool findNearest(const CurveEditor& editor, std::vector<Part> EditedCurve::*parts,
  const Distance& distanceOf, double reach, int found[2])
{
  double least = reach;
  for (std::size_t curve = 0; curve < editor.curveCount(); ++curve)
  {
    const std::vector<Part>& all = editor.curve(curve).*parts;
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      const double distance = distanceOf(all[k]);
      if (distance < least)
      {
        least = distance;
        found[0] = static_cast<int>(curve);
        found[1] = static_cast<int>(k);
      }
    }
  }
  return least < reach;
}
}

//------------------------------------------------------------------------------
vtkFeatureCurveEditor::vtkFeatureCurveEditor() = default;

//------------------------------------------------------------------------------
vtkFeatureCurveEditor::~vtkFeatureCurveEditor() = default;

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Curves: " << this->GetNumberOfCurves() << "\n";
  os << indent << "ViewDirection: " << this->ViewDirection[0] << " " << this->ViewDirection[1]
     << " " << this->ViewDirection[2] << "\n";
  os << indent << "SnapToBoundary: " << this->SnapToBoundary << "\n";
  os << indent << "SnapToCorners: " << this->SnapToCorners << "\n";
  os << indent << "SnapToVertices: " << this->SnapToVertices << "\n";
  os << indent << "SnapToCurves: " << this->SnapToCurves << "\n";
  os << indent << "SnapToDartTips: " << this->SnapToDartTips << "\n";
  os << indent << "SnapToMirrorPlane: " << this->SnapToMirrorPlane << "\n";
  os << indent << "Message: " << this->Message << "\n";
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetNumberOfCurves() const
{
  return this->Drawn ? static_cast<int>(this->Drawn->editor.curveCount()) : 0;
}

//------------------------------------------------------------------------------
std::string vtkFeatureCurveEditor::GetCurveName(int curve) const
{
  return curveOf(this->Drawn.get(), curve).traits.name;
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetCurveType(int curve) const
{
  return static_cast<int>(curveOf(this->Drawn.get(), curve).traits.type);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetCurveKeyShape(int curve) const
{
  return static_cast<int>(curveOf(this->Drawn.get(), curve).traits.keyShape);
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::GetCurveTolerance(int curve) const
{
  return curveOf(this->Drawn.get(), curve).traits.tolerance;
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::GetCurveEase(int curve) const
{
  return curveOf(this->Drawn.get(), curve).traits.ease.fraction;
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetCurveEasedPiece(int curve) const
{
  return static_cast<int>(curveOf(this->Drawn.get(), curve).traits.ease.piece);
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::GetCurveClosed(int curve) const
{
  return curveOf(this->Drawn.get(), curve).closed;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::GetCurveMirrored(int curve) const
{
  return curveOf(this->Drawn.get(), curve).traits.mirrored;
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::GetCurveLength(int curve) const
{
  return lengthOf(curveOf(this->Drawn.get(), curve));
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetNumberOfNodes(int curve) const
{
  return static_cast<int>(curveOf(this->Drawn.get(), curve).nodes.size());
}

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::GetNode(int curve, int node, double point[3]) const
{
  const bool there = node >= 0 && node < this->GetNumberOfNodes(curve);
  const Point3 place =
    there ? curveOf(this->Drawn.get(), curve).nodes[idOf(node)].position : Point3(Point3::Zero());
  std::copy_n(place.data(), 3, point);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetNumberOfSegments(int curve) const
{
  return static_cast<int>(curveOf(this->Drawn.get(), curve).segments.size());
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetSegmentKind(int curve, int segment) const
{
  return segment >= 0 && segment < this->GetNumberOfSegments(curve)
    ? static_cast<int>(curveOf(this->Drawn.get(), curve).kinds[idOf(segment)])
    : 0;
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::GetSegmentLength(int curve, int segment) const
{
  return segment >= 0 && segment < this->GetNumberOfSegments(curve)
    ? lengthOf(curveOf(this->Drawn.get(), curve).segments[idOf(segment)])
    : 0.0;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::GetCurves(vtkPolyData* curves) const
{
  bridge::writeCurveSet(this->Drawn ? this->Drawn->editor.state() : CurveSet(), curves);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::GetCurve(int curve, vtkPolyData* line) const
{
  bridge::writeCurve(curveOf(this->Drawn.get(), curve), line);
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::HasMirrorPlane() const
{
  return this->Drawn && this->Drawn->editor.state().mirror;
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetNumberOfCommands() const
{
  return this->Drawn ? static_cast<int>(this->Drawn->editor.commandCount()) : 0;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::CanUndo() const
{
  return this->Drawn && this->Drawn->editor.canUndo();
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::CanRedo() const
{
  return this->Drawn && this->Drawn->editor.canRedo();
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
  this->Message = flattening::inWords(status);
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
    flattening::LoadedSurface loaded =
      bridge::loadSurface(surface, CoincidentPoints::Automatic, flattening::Defects::Heal);
    if (loaded.outcome.refused() || loaded.prepared.mesh.triangleCount() == 0)
    {
      return this->Refuse(flattening::inWords(loaded.outcome));
    }
    this->Drawn = std::make_unique<bridge::CurveEditorModel>(
      std::make_shared<const DrawingSurface>(std::move(loaded.prepared.mesh)));
    this->Message.clear();
    for (const std::string& mending : loaded.mendings)
    {
      this->Message += (this->Message.empty() ? "" : "; ") + mending;
    }
  }
  catch (const std::bad_alloc&)
  {
    return this->Refuse("out of memory");
  }
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
    CurveTraits traits = curveOf(this->Drawn.get(), curve).traits;
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

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::SetViewDirection(const double direction[3])
{
  if (isFinite(direction))
  {
    std::copy_n(direction, 3, this->ViewDirection);
  }
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::SnapPoint(
  const double point[3], double reach, int exceptCurve, double snapped[3]) const
{
  std::copy_n(point, 3, snapped);
  if (!this->Drawn || !isFinite(point))
  {
    return NOTHING;
  }
  SnapOptions options;
  options.reach = reach;
  options.boundary = this->SnapToBoundary;
  options.corner = this->SnapToCorners;
  options.vertex = this->SnapToVertices;
  options.curve = this->SnapToCurves;
  options.dartTip = this->SnapToDartTips;
  options.mirrorPlane = this->SnapToMirrorPlane;
  options.exceptCurve = exceptCurve;
  options.sight = SightMetric(pointOf(this->ViewDirection));
  const DrawingSurface& surface = this->Drawn->editor.surface();
  const SnappedPoint result =
    snapPoint(surface, this->Drawn->editor.state(), surface.pointNear(pointOf(point)), options);
  std::copy_n(result.point.position.data(), 3, snapped);
  return static_cast<int>(result.target);
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::PreviewSegment(
  const double from[3], const double to[3], int kind, vtkPolyData* line) const
{
  line->Initialize();
  if (!this->Drawn || !isFinite(from) || !isFinite(to))
  {
    return -1.0;
  }
  const DrawingSurface& surface = this->Drawn->editor.surface();
  const DrawnSegment drawn = this->Drawn->preview.draw(
    kindOf(kind), surface.pointNear(pointOf(from)), surface.pointNear(pointOf(to)));
  if (drawn.status.refused())
  {
    return -1.0;
  }
  bridge::writePath(drawn.path, line);
  return lengthOf(drawn.path);
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::GetDistance(int curve, const double point[3]) const
{
  const EditedCurve& found = curveOf(this->Drawn.get(), curve);
  if (found.segments.empty() || !isFinite(point))
  {
    return vtkMath::Nan();
  }
  const DrawingSurface& surface = this->Drawn->editor.surface();
  const PathDistance distance =
    distanceFrom(surface.graph(), wholePath(found), surface.pointNear(pointOf(point)));
  return distance.way.status.refused() ? vtkMath::Nan()
    : distance.left                    ? distance.way.length
                                       : -distance.way.length;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::FindNode(const double point[3], double reach, int found[2]) const
{
  const SightMetric sight(pointOf(this->ViewDirection));
  return this->Drawn &&
    findNearest(
      this->Drawn->editor, &EditedCurve::nodes,
      [&](const SurfacePoint& node) { return sight.distance(node.position, pointOf(point)); },
      reach, found);
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::FindSegment(const double point[3], double reach, int found[2]) const
{
  const SightMetric sight(pointOf(this->ViewDirection));
  return this->Drawn &&
    findNearest(
      this->Drawn->editor, &EditedCurve::segments,
      [&](const SurfacePath& segment) { return distanceTo(segment, sight, pointOf(point)); }, reach,
      found);
}
