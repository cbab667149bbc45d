// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveCutter.h"

#include "Flattening/WireReport.h"
#include "FlatteningOutput.h"
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
      bridge::writeCutSurface(*source, cut, bridge::makePoints(cut.mesh.points()), surface);
      bridge::writeSeamPairs(cut, surface);
      bridge::writeWires(flattening::traceWires(mesh, cut, curves), curves, surface,
        vtkPolyData::GetData(outputVector, 1));
    }
  }
  this->WriteRunStatus(surface);
  return 1;
}
