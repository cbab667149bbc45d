// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceCurve.h"

#include "Base/Types.h"
#include "CurveEditorData.h"
#include "CurvedPolyData.h"
#include "Editing/ControlledCurve.h"
#include "ListChanges.h"
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

}

//------------------------------------------------------------------------------
vtkSurfaceCurve::vtkSurfaceCurve()
{
  this->SetOptionalPort(1);
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
  bridge::change(this, this->CurveName, name);
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
    if (!(normal.stableNorm() > 0.0) || !isFinite(normal) || !isFinite(set.mirror->origin))
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
  CurveControl control;
  control.traits.name = this->CurveName;
  control.traits.type = static_cast<flattening::CurveType>(this->CurveType);
  control.traits.keyShape = static_cast<flattening::KeyShape>(this->KeyShape);
  control.traits.tolerance = this->LengthTolerance;
  control.traits.mirrored = this->Mirror;
  control.kind = static_cast<flattening::SegmentKind>(this->SegmentKind);
  control.closed = this->Closed;
  control.tight = this->Tight;
  control.offset = this->Offset;
  control.mirror = set.mirror;
  std::vector<EditedCurve> curves;
  if (!status.refused())
  {
    status = drawControlledCurves(*this->Drawn->surface, controls, control, curves);
  }
  for (EditedCurve& curve : curves)
  {
    set.curves.push_back(std::make_shared<const EditedCurve>(std::move(curve)));
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
