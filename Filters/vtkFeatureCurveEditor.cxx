// SPDX-License-Identifier: BSD-3-Clause
// The state of vtkFeatureCurveEditor; its commands and what finds things near a point are in files
// of their own.
#include "vtkFeatureCurveEditor.h"

#include "CurveEditorData.h"
#include "CurveEditorModel.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace flattening;
using bridge::idOf;

vtkStandardNewMacro(vtkFeatureCurveEditor);

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
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found ? found->traits.name : "";
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetCurveType(int curve) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found ? static_cast<int>(found->traits.type) : 0;
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetCurveKeyShape(int curve) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found ? static_cast<int>(found->traits.keyShape) : 0;
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::GetCurveTolerance(int curve) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found ? found->traits.tolerance : 0.0;
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::GetCurveEase(int curve) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found ? found->traits.ease.fraction : 0.0;
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetCurveEasedPiece(int curve) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found ? static_cast<int>(found->traits.ease.piece) : -1;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::GetCurveClosed(int curve) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found && found->closed;
}

//------------------------------------------------------------------------------
bool vtkFeatureCurveEditor::GetCurveMirrored(int curve) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found && found->traits.mirrored;
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::GetCurveLength(int curve) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found ? lengthOf(*found) : 0.0;
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetNumberOfNodes(int curve) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found ? static_cast<int>(found->nodes.size()) : 0;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveEditor::GetNode(int curve, int node, double point[3]) const
{
  const bool there = node >= 0 && node < this->GetNumberOfNodes(curve);
  const Point3 place =
    there ? this->Drawn->curve(curve)->nodes[idOf(node)].position : Point3(Point3::Zero());
  std::copy_n(place.data(), 3, point);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetNumberOfSegments(int curve) const
{
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  return found ? static_cast<int>(found->segments.size()) : 0;
}

//------------------------------------------------------------------------------
int vtkFeatureCurveEditor::GetSegmentKind(int curve, int segment) const
{
  return segment >= 0 && segment < this->GetNumberOfSegments(curve)
    ? static_cast<int>(this->Drawn->curve(curve)->kinds[idOf(segment)])
    : 0;
}

//------------------------------------------------------------------------------
double vtkFeatureCurveEditor::GetSegmentLength(int curve, int segment) const
{
  return segment >= 0 && segment < this->GetNumberOfSegments(curve)
    ? lengthOf(this->Drawn->curve(curve)->segments[idOf(segment)])
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
  const EditedCurve* const found = this->Drawn ? this->Drawn->curve(curve) : nullptr;
  bridge::writeCurve(found ? *found : EditedCurve(), line);
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
