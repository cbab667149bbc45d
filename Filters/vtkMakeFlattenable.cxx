// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMakeFlattenable.h"

#include "AttributeArrays.h"
#include "CurvedPolyData.h"
#include "FilterExecution.h"
#include "ListChanges.h"
#include "Options/OptionStructures.h"
#include "Report/FlatteningRun.h"
#include "Report/FlatteningTables.h"
#include "SurfaceInput.h"
#include "SurfaceOutput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <set>

vtkStandardNewMacro(vtkMakeFlattenable);

namespace
{
constexpr int surfacePort = 5; // and its curves behind it
constexpr int beforePort = 7;
constexpr int piecesBeforePort = 8;
constexpr int measurePort = 9;
}

//------------------------------------------------------------------------------
vtkMakeFlattenable::vtkMakeFlattenable()
{
  this->SetOptionalPort(2);
  this->SetTablePort(piecesBeforePort);
  this->SetTablePort(measurePort);
  this->Trials = vtkSmartPointer<vtkTable>::New();
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::AddKeptCurve(const std::string& curve)
{
  if (this->KeptCurves.insert(curve).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::RemoveAllKeptCurves()
{
  flattening::bridge::changeToNone(this, this->KeptCurves);
}

//------------------------------------------------------------------------------
int vtkMakeFlattenable::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  namespace bridge = flattening::bridge;
  this->Begin(outputVector);
  this->Trials = vtkSmartPointer<vtkTable>::New(); // the caller may have kept that of the last run
  const auto output = [outputVector](int port) { return vtkPolyData::GetData(outputVector, port); };
  flattening::OptionStructures options = this->OptionsForCore();
  options.flattening = this->Settings();
  const flattening::LoadedBody body = bridge::loadBody(vtkPolyData::GetData(inputVector[2]));
  if (const auto source = this->LoadInput(inputVector))
  {
    flattening::FlatteningRun run(*source);
    std::optional<flattening::FlattenableSurface> result;
    if (this->Weigh(run, *source))
    {
      result = run.reshape(this->KeptCurves, body, options, bridge::executionOf(this));
    }
    bridge::CurvedPolyData moved = *source;
    moved.imprinted.mesh = result ? result->mesh : flattening::TriangleMesh();
    if (this->TakeResult(run, moved, result ? &result->after : nullptr, options.flattening,
          inputVector, outputVector))
    {
      std::vector<std::string> warnings;
      vtkPolyData* const surface = output(surfacePort);
      bridge::writeImprint(moved, surface, output(surfacePort + 1), warnings);
      bridge::addColumns(
        surface->GetPointData(), flattening::shiftArrays(source->imprinted.mesh, *result));
      surface->GetPointData()->SetActiveScalars("ShiftDistance");
      for (const int port : { 2, surfacePort, surfacePort + 1 })
      {
        output(port)->GetPointData()->SetNormals(nullptr); // those of the design
      }
      const vtkNew<vtkPolyData> wires;
      const vtkNew<vtkPolyData> cut;
      bridge::writeFlattening(
        *source, result->before, options.flattening, output(beforePort), wires, cut);
      bridge::writeTable(
        flattening::pieceTable(*source, result->before, this->LengthUnitOf(inputVector),
          bridge::textsOfCells(output(beforePort), "PieceName")),
        vtkTable::GetData(outputVector, piecesBeforePort));
      bridge::writeTable(
        flattening::shiftTable(*result), vtkTable::GetData(outputVector, measurePort));
      this->Trials = bridge::makeTable(flattening::shiftTrialTable(result->trials));
      this->Warn(warnings);
    }
  }
  this->WriteRunStatus(output(0));
  return 1;
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const std::string& curve : this->KeptCurves)
  {
    os << indent << "KeptCurve: " << curve << "\n";
  }
}
