// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlatteningTable.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <vector>

vtkStandardNewMacro(vtkFlatteningTable);

namespace
{
using Names = std::vector<const char*>;

/// What vtkWireWarpingFilter gives for each piece. Other arrays may happen to be as long.
const Names pieceArrays{ "Status", "StatusMessage", "StatusDefect", "StatusIdKind", "Triangles",
  "Vertices", "WirePatches", "WireNodes", "FreeWireNodes", "Constraints", "Iterations",
  "EdgeLengthError", "MaxEdgeLengthError", "AngleErrorMean", "GlobalHomogeneity",
  "GlobalAspectRatio", "AreaError", "StrainP95", "RigidEnergy", "FlippedTriangles", "Overlaps",
  "OverlapsComplete", "Objective", "ClosureResidual", "CutLength", "DistortionEnergy",
  "AngleEnergy", "ReleaseFirst", "ObjectiveWithoutFirst", "SolverUsed", "EnergyUsed", "Repaired",
  "Fallbacks" };

const Names curveArrays{ "CurveNames", "CurveTypes", "CurveRestLengths", "CurveFlatLengths",
  "CurveLengthErrors", "CurveTolerances", "CurveClosedLengths", "CurveSensitivities",
  "CurveReleased" };

void addNumbers(vtkTable* table, const char* name, vtkIdType rows)
{
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(name);
  numbers->SetNumberOfValues(rows);
  for (vtkIdType row = 0; row < rows; ++row)
  {
    numbers->SetValue(row, row);
  }
  table->AddColumn(numbers);
}

void addColumns(vtkTable* table, vtkFieldData* field, const Names& names, vtkIdType rows)
{
  for (const char* name : names)
  {
    vtkAbstractArray* const array = field->GetAbstractArray(name);
    if (array && array->GetNumberOfTuples() == rows && array->GetNumberOfComponents() == 1)
    {
      table->AddColumn(array);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkFlatteningTable::vtkFlatteningTable() = default;

//------------------------------------------------------------------------------
vtkFlatteningTable::~vtkFlatteningTable() = default;

//------------------------------------------------------------------------------
int vtkFlatteningTable::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkFlatteningTable::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* const input = vtkPolyData::GetData(inputVector[0]);
  vtkTable* const table = vtkTable::GetData(outputVector);
  vtkFieldData* const field = input->GetFieldData();
  if (vtkAbstractArray* const triangles = field->GetAbstractArray("Triangles"))
  {
    const vtkIdType rows = triangles->GetNumberOfTuples();
    addNumbers(table, "Piece", rows);
    addColumns(table, field, pieceArrays, rows);
  }
  else if (vtkAbstractArray* const curves = field->GetAbstractArray("CurveNames"))
  {
    addColumns(table, field, curveArrays, curves->GetNumberOfTuples());
  }
  else
  {
    vtkWarningMacro(
      << "the input has no measures of flat pieces (output 0 of vtkWireWarpingFilter) "
         "or of their curves (output 1); the table is empty");
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkFlatteningTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
