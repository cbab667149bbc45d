// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveCutter.h"

#include "AttributeArrays.h"
#include "Flattening/WireReport.h"
#include "Report/FlatteningArrays.h"
#include "SurfaceOutput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkFeatureCurveCutter);

//------------------------------------------------------------------------------
vtkFeatureCurveCutter::vtkFeatureCurveCutter()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveCutter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  namespace bridge = flattening::bridge;
  this->Begin(outputVector);
  vtkPolyData* surface = vtkPolyData::GetData(outputVector, 0);
  const auto source = this->LoadInput(inputVector);
  if (source)
  {
    const flattening::TriangleMesh& mesh = source->imprinted.mesh;
    const std::vector<flattening::FeatureCurve>& curves = source->imprinted.curves;
    const flattening::CutSurface cut = flattening::cutSurface(mesh, curves);
    if (this->Conclude(source->outcomeOfStage(cut.status)))
    {
      const flattening::CutArrays arrays = flattening::cutArrays(*source, cut);
      const std::vector<flattening::Wire> wires = flattening::traceWires(mesh, cut, curves);
      bridge::writeCutSurface(*source, cut, arrays, bridge::makePoints(arrays.points), surface);
      bridge::addColumns(surface->GetFieldData(), { flattening::seamPairs(cut) });
      bridge::writeWires(wires, flattening::wireArrays(wires, curves), surface,
        vtkPolyData::GetData(outputVector, 1));
    }
  }
  this->WriteRunStatus(surface);
  return 1;
}
