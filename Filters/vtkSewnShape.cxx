// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSewnShape.h"

#include "AttributeArrays.h"
#include "FilterExecution.h"
#include "Input/ClothInput.h"
#include "Input/StatusWords.h"
#include "Options/OptionStructures.h"
#include "Options/OptionValues.h"
#include "PolyDataSets.h"
#include "Report/SewingReport.h"
#include "SurfaceInput.h"
#include "SurfaceOutput.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>

vtkStandardNewMacro(vtkSewnShape);

namespace flattening::bridge
{
namespace
{
/// Writes what vtkSewnShape documents.
/// \param design the input in space. \param sewn its output 0. \param designed its output 1.
void writeSewn(vtkPolyData* design, const LoadedSurface& surface, const SewnArrays& arrays,
  vtkPolyData* sewn, vtkPolyData* designed, std::vector<std::string>& warnings)
{
  const auto pointArrays = wholePointArrays(design, warnings);
  const auto cellArrays = wholeCellArrays(design, warnings);
  for (vtkPolyData* output : { sewn, designed })
  {
    output->SetPolys(makeTriangles(surface.input.triangles));
    output->GetPointData()->ShallowCopy(pointArrays);
    copyCellData(cellArrays, surface.input.cellOfTriangle, output);
    addColumns(output->GetCellData(), arrays.cellArrays);
    addColumns(
      output->GetPointData(), { output == sewn ? arrays.distance : arrays.designDistance });
    output->GetPointData()->SetActiveScalars("Distance");
  }
  // Normals are those of the design.
  sewn->GetPointData()->SetNormals(nullptr);
  sewn->SetPoints(makePoints(arrays.points));
  designed->SetPoints(design->GetPoints());
  addColumns(sewn->GetFieldData(), arrays.fieldArrays);
}

/// The pairs of edges that are sewn together.
Columns seamsOf(vtkPolyData* flat)
{
  vtkNew<vtkFieldData> field;
  if (vtkDataArray* const pairs = flat->GetFieldData()->GetArray("SeamPairs"))
  {
    field->AddArray(pairs);
  }
  return columnsOf(field);
}
}
}

//------------------------------------------------------------------------------
vtkSewnShape::vtkSewnShape()
{
  this->SetOptionalPort(2);
  this->SetTablePort(2);
  this->Iterations = vtkSmartPointer<vtkTable>::New();
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkSewnShape::AddOtherOptions(flattening::OptionValues& values)
{
  this->Superclass::AddOtherOptions(values);
  values.set(
    "Gravity", std::vector<double>{ this->Gravity[0], this->Gravity[1], this->Gravity[2] });
}

//------------------------------------------------------------------------------
vtkTable* vtkSewnShape::GetShapes()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

//------------------------------------------------------------------------------
int vtkSewnShape::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  this->Iterations = vtkSmartPointer<vtkTable>::New();
  vtkPolyData* design = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* const flat = vtkPolyData::GetData(inputVector[0]);
  const flattening::Columns seams = flattening::bridge::seamsOf(flat);
  const flattening::SewnInput input =
    flattening::makeSewnInput(flattening::bridge::loadMappedSurface(design, flat, nullptr),
      seams.empty() ? nullptr : &seams.front());
  const flattening::LoadedBody body =
    flattening::bridge::loadBody(vtkPolyData::GetData(inputVector[2]));
  if (this->Conclude(input.outcome) && this->Conclude(body.outcome))
  {
    flattening::SewingOptions options = this->OptionsForCore().sewing;
    if (*this->GetMaterial() != '\0')
    {
      options.material = flattening::readCloth(this->GetMaterial()).material;
    }
    options.body = body.get();
    const flattening::SewingResult result = flattening::sewPieces(
      input.cut, input.map.positions, options, flattening::bridge::executionOf(this));
    if (this->Conclude(flattening::inInput(result.status, input.map.surface.input.cellOfTriangle)))
    {
      const flattening::SewnArrays arrays =
        flattening::sewnArrays(*flattening::bridge::geometryOf(design).points, input, result);
      std::vector<std::string> warnings;
      flattening::bridge::writeSewn(
        design, input.map.surface, arrays, output, vtkPolyData::GetData(outputVector, 1), warnings);
      warnings.insert(warnings.end(), arrays.warnings.begin(), arrays.warnings.end());
      flattening::bridge::writeTable(arrays.shapes, vtkTable::GetData(outputVector, 2));
      this->Iterations = flattening::bridge::makeTable(arrays.iterations);
      this->Warn(warnings);
    }
  }
  this->WriteRunStatus(output);
  return 1;
}
