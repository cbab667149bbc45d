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

namespace flattening::bridge
{
namespace
{
/// Measures a mapped surface and writes what vtkFlatteningQuality documents.
void writeQuality(vtkPolyData* input, const MappedSurface& map, std::size_t mostListedOverlaps,
  const Execution& execution, vtkPolyData* output, vtkTable* measures,
  std::vector<std::string>& warnings)
{
  const QualityReport report = reportQuality(map, mostListedOverlaps, execution);
  const std::vector<std::string>& mendings = map.surface.mendings;
  warnings.insert(warnings.end(), mendings.begin(), mendings.end());
  output->SetPoints(input->GetPoints());
  output->SetPolys(makeTriangles(map.surface.input.triangles));
  output->GetPointData()->ShallowCopy(wholePointArrays(input, warnings));
  copyCellData(wholeCellArrays(input, warnings), map.surface.input.cellOfTriangle, output);
  addColumns(output->GetCellData(), report.cells);

  vtkFieldData* field = output->GetFieldData();
  field->PassData(fieldArrays(input, warnings));
  addColumns(field, { report.overlapEdges });
  writeTable(report.measures, measures);
}
}
}

//------------------------------------------------------------------------------
vtkFlatteningQuality::vtkFlatteningQuality()
{
  this->SetNumberOfInputPorts(3);
  this->SetTablePort(1);
  this->MaximumOverlaps = static_cast<int>(flattening::mostListedOverlaps);
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatteningQuality::GetMeasures()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkFlatteningQuality::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFlatteningQuality::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  const flattening::MappedSurface map = flattening::bridge::loadMappedSurface(
    surface, vtkPolyData::GetData(inputVector[1]), vtkPolyData::GetData(inputVector[2]));
  if (this->Conclude(map.outcome))
  {
    std::vector<std::string> warnings;
    flattening::bridge::writeQuality(surface, map, static_cast<std::size_t>(this->MaximumOverlaps),
      flattening::bridge::executionOf(this), output, vtkTable::GetData(outputVector, 1), warnings);
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
