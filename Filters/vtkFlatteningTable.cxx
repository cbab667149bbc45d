// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlatteningTable.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <utility>
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
  "Fallbacks", "ForecastAreaLoss", "ForecastAreaLossAfterCut", "ForecastCutFrom", "ForecastCutTo",
  "Verdict", "PieceNames", "FlatWidth", "FlatHeight", "AreaEasedIn", "AreaStretched",
  "WorstAreaChange", "WorstPlace", "SizeInWords", "EaseInWords", "StrainWarpRms", "StrainWeftRms",
  "ShearRms", "ShareOutOfLimit", "ShareOver5Percent", "ShareLocked", "ShearLimit", "GrainAngle",
  "GrainCurve", "OneWay" };

/// What vtkSewnShape gives for each shape.
const Names shapeArrays{ "Status", "StatusMessage", "Pieces", "Triangles", "Iterations",
  "Converged", "Size", "DistanceMean", "DistanceRMS", "DistanceP95", "DistanceMax",
  "RelativeDistanceMean", "RelativeDistanceRMS", "RelativeDistanceP95", "RelativeDistanceMax",
  "NormalDeviationMean", "StrainMean", "StrainP95", "StrainMax", "CompressedArea", "StrainWarpRms",
  "StrainWeftRms", "ShearRms", "BodyDepth", "SecondDistanceMean", "SeveralShapes", "MembraneEnergy",
  "BendingEnergy" };

const Names curveArrays{ "CurveNames", "CurveTypes", "CurveRestLengths", "CurveFlatLengths",
  "CurveLengthErrors", "CurveTolerances", "CurveClosedLengths", "CurveSensitivities",
  "CurveReleased" };

const Names keyArrays{ "KeyTrial", "KeyCurve", "KeyPrice", "AreaError", "StrainP95", "Status",
  "Released" };

/// Column, and the array of a refused surface that it is.
const std::vector<std::pair<const char*, const char*>> refusalArrays{ { "Status", "RunStatus" },
  { "StatusMessage", "RunStatusMessage" } };

void addNumbers(vtkTable* table, const char* name, vtkIdType rows, vtkIdType first = 0)
{
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(name);
  numbers->SetNumberOfValues(rows);
  for (vtkIdType row = 0; row < rows; ++row)
  {
    numbers->SetValue(row, first + row);
  }
  table->AddColumn(numbers);
}

/// Whether a data set without rows is one that a flattening gives.
bool isOfFlattening(vtkPolyData* data)
{
  const bool wires = data->GetCellData()->HasArray("CurveId") != 0;
  const bool elsewhere = data->GetNumberOfPoints() == 0; // with another process
  return wires || elsewhere;
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
  if (vtkAbstractArray* const shapes = field->GetAbstractArray("DistanceMean"))
  {
    addNumbers(table, "Shape", shapes->GetNumberOfTuples());
    addColumns(table, field, shapeArrays, shapes->GetNumberOfTuples());
  }
  else if (vtkAbstractArray* const triangles = field->GetAbstractArray("Triangles"))
  {
    const vtkIdType rows = triangles->GetNumberOfTuples();
    addNumbers(table, "Piece", rows);
    addColumns(table, field, pieceArrays, rows);
  }
  else if (vtkAbstractArray* const curves = field->GetAbstractArray("CurveNames"))
  {
    addColumns(table, field, curveArrays, curves->GetNumberOfTuples());
  }
  else if (vtkAbstractArray* const trials = field->GetAbstractArray("KeyTrial"))
  {
    addColumns(table, field, keyArrays, trials->GetNumberOfTuples());
  }
  else if (field->HasArray("RunStatus") && input->GetNumberOfPoints() == 0)
  {
    addNumbers(table, "Piece", 1, -1);
    for (const auto& [name, array] : refusalArrays)
    {
      const auto column = vtk::TakeSmartPointer(field->GetAbstractArray(array)->NewInstance());
      column->DeepCopy(field->GetAbstractArray(array));
      column->SetName(name);
      table->AddColumn(column);
    }
  }
  else if (!isOfFlattening(input))
  {
    vtkWarningMacro(
      << "the input has no measures of flat pieces (output 0 of vtkWireWarpingFilter) "
         "or of their curves (output 1), or of vtkSewnShape; the table is empty");
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkFlatteningTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
