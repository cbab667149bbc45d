// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMakeFlattenable.h"

#include "AttributeArrays.h"
#include "CurvedPolyData.h"
#include "FieldArrays.h"
#include "FilterExecution.h"
#include "FlatteningOutput.h"
#include "ImprintOutput.h"
#include "ListChanges.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"
#include "Report/FlatteningArrays.h"
#include "Report/FlatteningTables.h"
#include "Report/ReshapingReport.h"
#include "Reshaping/FlattenableSurface.h"
#include "SurfaceInput.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <set>

vtkStandardNewMacro(vtkMakeFlattenable);

namespace flattening
{
namespace bridge
{
namespace
{
/// Writes the moved surface and its curves as vtkMakeFlattenable documents.
/// \param moved the source with its mesh moved
/// \param warnings get a sentence for each array of the curves that is left out
void writeMovedSurface(const CurvedPolyData& source, const CurvedPolyData& moved,
  const FlattenableSurface& result, vtkPolyData* surface, vtkPolyData* curves,
  std::vector<std::string>& warnings)
{
  writeImprint(moved, surface, curves, warnings);
  // Normals are those of the design.
  surface->GetPointData()->SetNormals(nullptr);
  curves->GetPointData()->SetNormals(nullptr);
  addColumns(surface->GetPointData(), shiftArrays(source.imprinted.mesh, result));
  surface->GetPointData()->SetActiveScalars("ShiftDistance");
}
}
}
}

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
  this->SetNumberOfInputPorts(3);
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
int vtkMakeFlattenable::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port < 2)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
vtkTable* vtkMakeFlattenable::GetTrials() const
{
  return this->Trials;
}

//------------------------------------------------------------------------------
int vtkMakeFlattenable::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  namespace bridge = flattening::bridge;
  this->Begin(outputVector);
  this->Trials = vtkSmartPointer<vtkTable>::New(); // the caller may have kept that of the last run
  const auto output = [outputVector](int port) { return vtkPolyData::GetData(outputVector, port); };
  flattening::FlattenableOptions options = this->OptionsForCore().reshaping;
  options.flattening = this->Settings();
  const flattening::LoadedBody body = bridge::loadBody(vtkPolyData::GetData(inputVector[2]));
  options.body = body.get();
  const auto source = this->LoadInput(inputVector);
  if (source && this->Conclude(body.outcome) &&
    this->Conclude(flattening::findCurves(this->KeptCurves, *source, options.kept)))
  {
    this->Warn(flattening::describeShortEnds(*source));
    const flattening::FlattenableSurface result = flattening::makeFlattenable(
      source->imprinted.mesh, source->imprinted.curves, options, bridge::executionOf(this));
    if (this->Conclude(source->outcomeOfStage(
          result.status, result.status.refused() ? nullptr : result.after.cut.get())))
    {
      std::vector<std::string> warnings;
      if (!result.after.leftOut.empty())
      {
        warnings.push_back(flattening::describeLeftOut(*source, result.after));
      }
      if (!result.boundMet)
      {
        warnings.push_back(flattening::describeShortfall(result, options));
      }
      const std::string unit = this->LengthUnitOf(inputVector);
      bridge::CurvedPolyData moved = *source;
      moved.imprinted.mesh = result.mesh;
      this->WriteFlattening(moved, result.after, options.flattening, unit, outputVector);
      output(2)->GetPointData()->SetNormals(nullptr); // those of the design
      bridge::writeMovedSurface(
        *source, moved, result, output(surfacePort), output(surfacePort + 1), warnings);
      const vtkNew<vtkPolyData> wires;
      const vtkNew<vtkPolyData> cut;
      bridge::writeFlattening(
        *source, result.before, options.flattening, output(beforePort), wires, cut);
      bridge::writeTable(flattening::pieceTable(*source, result.before, unit,
                           bridge::textsOfCells(output(beforePort), "PieceName")),
        vtkTable::GetData(outputVector, piecesBeforePort));
      bridge::writeTable(
        flattening::shiftTable(result), vtkTable::GetData(outputVector, measurePort));
      this->Trials = bridge::makeTable(flattening::shiftTrialTable(result.trials));
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
