// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlatteningQuality.h"

#include "AttributeArrays.h"
#include "Base/Execution.h"
#include "FilterExecution.h"
#include "Quality/BoundaryOverlap.h"
#include "Report/QualityReport.h"
#include "SurfaceInput.h"
#include "SurfaceOutput.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFlatteningQuality);

//------------------------------------------------------------------------------
vtkFlatteningQuality::vtkFlatteningQuality()
{
  this->SetOptionalPort(1);
  this->SetOptionalPort(2);
  this->SetTablePort(1);
  this->MaximumOverlaps = static_cast<int>(flattening::mostListedOverlaps);
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatteningQuality::GetMeasures()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkFlatteningQuality::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  namespace bridge = flattening::bridge;
  this->Begin(outputVector);
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  const flattening::MappedSurface map = bridge::loadMappedSurface(
    surface, vtkPolyData::GetData(inputVector[1]), vtkPolyData::GetData(inputVector[2]));
  if (this->Conclude(map.outcome))
  {
    const flattening::QualityReport report = flattening::reportQuality(
      map, static_cast<std::size_t>(this->MaximumOverlaps), bridge::executionOf(this));
    std::vector<std::string> warnings = map.surface.mendings;
    output->SetPoints(surface->GetPoints());
    output->SetPolys(bridge::makeTriangles(map.surface.input.triangles));
    output->GetPointData()->ShallowCopy(bridge::wholePointArrays(surface, warnings));
    bridge::copyCellData(
      bridge::wholeCellArrays(surface, warnings), map.surface.input.cellOfTriangle, output);
    bridge::addColumns(output->GetCellData(), report.cells);
    output->GetFieldData()->PassData(bridge::fieldArrays(surface, warnings));
    bridge::addColumns(output->GetFieldData(), { report.overlapEdges });
    bridge::writeTable(report.measures, vtkTable::GetData(outputVector, 1));
    this->Warn(warnings);
  }
  this->WriteRunStatus(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkFlatteningQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumOverlaps: " << this->MaximumOverlaps << "\n";
}
