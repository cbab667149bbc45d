// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceCurve.h"

#include "Base/Types.h"
#include "CurveEditorData.h"
#include "CurvedPolyData.h"
#include "Editing/CurveDrawing.h"
#include "Editing/DerivedCurves.h"
#include "SurfaceInput.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace flattening;

vtkStandardNewMacro(vtkSurfaceCurve);

//------------------------------------------------------------------------------
class vtkSurfaceCurve::Kept
{
public:
  bridge::SurfaceOrigin origin;
  std::unique_ptr<const DrawingSurface> surface;
};

namespace
{
/// The control points of one curve after the other.
std::vector<Points3> readControlPoints(vtkPolyData* data)
{
  std::vector<Points3> curves;
  vtkCellArray* const lines = data->GetLines();
  const auto pointOf = [data](vtkIdType id) {
    Point3 point;
    data->GetPoint(id, point.data());
    return point;
  };
  if (lines->GetNumberOfCells() == 0)
  {
    curves.emplace_back();
    for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
    {
      curves.back().push_back(pointOf(id));
    }
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    lines->GetCellAtId(line, ids);
    curves.emplace_back();
    for (const vtkIdType id : *ids)
    {
      if (id >= 0 && id < data->GetNumberOfPoints())
      {
        curves.back().push_back(pointOf(id));
      }
    }
  }
  return curves;
}

bool allFinite(const Points3& points)
{
  return std::all_of(
    points.begin(), points.end(), [](const Point3& point) { return isFinite(point); });
}

/// Nodes of a curve at its control points, each once where several in a row mean the same point.
Status placeNodes(const DrawingSurface& surface, const Points3& points, EditedCurve& curve)
{
  if (!allFinite(points))
  {
    return { StatusCode::NonFinitePoint, "a control point has a coordinate that is not finite", {},
      { Remedy::MendPoints } };
  }
  for (const Point3& point : points)
  {
    const SurfacePoint node = surface.pointNear(point);
    if (curve.nodes.empty() || curve.nodes.back().position != node.position)
    {
      curve.nodes.push_back(node);
    }
  }
  // A polyline that ends where it starts is closed.
  const bool returns =
    curve.nodes.size() > 2 && curve.nodes.front().position == curve.nodes.back().position;
  if (returns)
  {
    curve.nodes.pop_back();
    curve.closed = true;
  }
  return {};
}

Status drawCurveOf(const DrawingSurface& surface, const Points3& points,
  const std::optional<MirrorPlane>& mirror, SegmentKind kind, EditedCurve& curve)
{
  Status status = placeNodes(surface, points, curve);
  if (!status.ok())
  {
    return status;
  }
  const std::size_t fewest = curve.closed && kind != SegmentKind::Section ? 3 : 2;
  if (curve.nodes.size() < fewest)
  {
    const char* const more = curve.closed && curve.nodes.size() == 2
      ? "more control points, or the kind Section, which goes round through two"
      : "more control points";
    return { StatusCode::CurveTooShort,
      std::to_string(curve.nodes.size()) + " different control points are given where " +
        std::to_string(fewest) + " are needed",
      {}, { { Remedy::Give, more } } };
  }
  curve.kinds.assign(segmentCount(curve.nodes.size(), curve.closed), kind);
  return drawCurve(surface, { {}, mirror }, nullptr, curve);
}

/// Puts what follows from a curve, the last one, in its place.
Status replaceCurve(const DrawingSurface& surface, const std::optional<MirrorPlane>& mirror,
  DerivedCurves derived, std::vector<EditedCurve>& curves)
{
  const EditedCurve drawn = std::move(curves.back());
  curves.pop_back();
  Status status = std::move(derived.status);
  for (EditedCurve& part : derived.curves)
  {
    if (!status.refused())
    {
      part.traits = drawn.traits;
      status = drawCurve(surface, { {}, mirror }, nullptr, part);
      curves.push_back(std::move(part));
    }
  }
  return status;
}
}

//------------------------------------------------------------------------------
vtkSurfaceCurve::vtkSurfaceCurve()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkSurfaceCurve::~vtkSurfaceCurve() = default;

//------------------------------------------------------------------------------
void vtkSurfaceCurve::SetNumberOfControlPoints(int number)
{
  const auto count = static_cast<std::size_t>(std::max(number, 0));
  if (count != this->ControlPoints.size())
  {
    this->ControlPoints.resize(count, { 0.0, 0.0, 0.0 });
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceCurve::SetControlPoint(int id, double x, double y, double z)
{
  const std::array<double, 3> point{ x, y, z };
  if (id >= 0 && id < this->GetNumberOfControlPoints() &&
    this->ControlPoints[static_cast<std::size_t>(id)] != point)
  {
    this->ControlPoints[static_cast<std::size_t>(id)] = point;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceCurve::GetControlPoint(int id, double point[3]) const
{
  const bool known = id >= 0 && id < this->GetNumberOfControlPoints();
  for (std::size_t k = 0; k < 3; ++k)
  {
    point[k] = known ? this->ControlPoints[static_cast<std::size_t>(id)][k] : 0.0;
  }
}

//------------------------------------------------------------------------------
const char* vtkSurfaceCurve::GetSegmentKindAsString() const
{
  static const char* const names[] = { "Geodesic", "Section", "Edges", "Spline" };
  return names[this->SegmentKind];
}

//------------------------------------------------------------------------------
const char* vtkSurfaceCurve::GetCurveTypeAsString() const
{
  static const char* const names[] = { "Accessory", "Key", "Dart", "Seam" };
  return names[this->CurveType];
}

//------------------------------------------------------------------------------
const char* vtkSurfaceCurve::GetKeyShapeAsString() const
{
  static const char* const names[] = { "Surface", "Straight" };
  return names[this->KeyShape];
}

//------------------------------------------------------------------------------
void vtkSurfaceCurve::SetCurveName(const std::string& name)
{
  if (name != this->CurveName)
  {
    this->CurveName = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkSurfaceCurve::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceCurve::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  vtkPolyData* const input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  const bridge::SurfaceOrigin origin(input);
  if (!this->Drawn || !this->Drawn->origin.sameAs(origin))
  {
    this->Drawn.reset();
    flattening::LoadedSurface loaded =
      bridge::loadSurface(input, CoincidentPoints::Automatic, flattening::Defects::Heal);
    if (!this->Conclude(loaded.outcome))
    {
      this->WriteRunStatus(output);
      return 1;
    }
    this->Drawn = std::make_unique<Kept>();
    this->Drawn->origin = origin;
    this->Drawn->surface = std::make_unique<const DrawingSurface>(std::move(loaded.prepared.mesh));
  }
  CurveSet set;
  Status status;
  if (this->Mirror)
  {
    const Point3 normal(this->MirrorNormal);
    set.mirror = MirrorPlane{ Point3(this->MirrorOrigin), normal.stableNormalized() };
    if (!(normal.stableNorm() > 0.0) || !allFinite({ normal, set.mirror->origin }))
    {
      status = { StatusCode::InvalidOption, "the mirror plane has no normal", {},
        { { Remedy::Give, "a MirrorNormal that is not zero" } } };
    }
  }
  std::vector<Points3> controls;
  if (vtkPolyData* const points = vtkPolyData::GetData(inputVector[1]))
  {
    controls = readControlPoints(points);
  }
  else
  {
    controls.emplace_back();
    for (const std::array<double, 3>& point : this->ControlPoints)
    {
      controls.back().emplace_back(point.data());
    }
  }
  std::vector<EditedCurve> curves;
  std::size_t drawn = 0; // polylines
  for (; drawn < controls.size() && !status.refused(); ++drawn)
  {
    EditedCurve curve;
    curve.closed = this->Closed;
    curve.traits.type = static_cast<flattening::CurveType>(this->CurveType);
    curve.traits.keyShape = static_cast<flattening::KeyShape>(this->KeyShape);
    curve.traits.tolerance = this->LengthTolerance;
    curve.traits.mirrored = this->Mirror;
    status = drawCurveOf(*this->Drawn->surface, controls[drawn], set.mirror,
      static_cast<flattening::SegmentKind>(this->SegmentKind), curve);
    curves.push_back(std::move(curve));
    const DrawingSurface& surface = *this->Drawn->surface;
    if (this->Tight && !status.refused())
    {
      status = replaceCurve(surface, set.mirror, tightCurve(surface, curves.back()), curves);
    }
    if (this->Offset != 0.0 && !status.refused())
    {
      status = replaceCurve(
        surface, set.mirror, offsetCurves(surface, curves.back(), this->Offset), curves);
    }
  }
  if (status.refused() && !curves.empty() && (controls.size() > 1 || !this->CurveName.empty()))
  {
    const std::string number = controls.size() > 1 ? std::to_string(drawn) : "";
    status.message = "curve " +
      (this->CurveName.empty()
          ? number
          : "\"" + this->CurveName + (number.empty() ? "" : " " + number) + "\"") +
      ": " + status.message;
  }
  const bool numbered = curves.size() > 1 && !this->CurveName.empty();
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    curves[k].traits.name = this->CurveName + (numbered ? " " + std::to_string(k + 1) : "");
    set.curves.push_back(std::make_shared<const EditedCurve>(std::move(curves[k])));
  }
  if (this->Conclude(status))
  {
    bridge::writeCurveSet(set, output);
    output->GetCellData()->SetActiveScalars("CurveType");
  }
  this->WriteRunStatus(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceCurve::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ControlPoints: " << this->ControlPoints.size() << "\n";
  os << indent << "SegmentKind: " << this->GetSegmentKindAsString() << "\n";
  os << indent << "Closed: " << (this->Closed ? "On" : "Off") << "\n";
  os << indent << "Tight: " << (this->Tight ? "On" : "Off") << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "CurveType: " << this->GetCurveTypeAsString() << "\n";
  os << indent << "CurveName: " << this->CurveName << "\n";
  os << indent << "KeyShape: " << this->GetKeyShapeAsString() << "\n";
  os << indent << "LengthTolerance: " << this->LengthTolerance << "\n";
  os << indent << "Mirror: " << (this->Mirror ? "On" : "Off") << "\n";
  os << indent << "MirrorOrigin: " << this->MirrorOrigin[0] << " " << this->MirrorOrigin[1] << " "
     << this->MirrorOrigin[2] << "\n";
  os << indent << "MirrorNormal: " << this->MirrorNormal[0] << " " << this->MirrorNormal[1] << " "
     << this->MirrorNormal[2] << "\n";
}
