// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlatPieceAlgorithm.h"

#include "BlockLayout.h"
#include "ClothInput.h"
#include "CurvedSurface.h"
#include "CutEndWords.h"
#include "Distribution.h"
#include "FilterExecution.h"
#include "Flattening/SurfaceFlattening.h"
#include "FlatteningOutput.h"
#include "FlatteningTables.h"
#include "OptionVisitor.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"
#include "PieceSizes.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

namespace
{
constexpr int piecePort = 3;
constexpr int curvePort = 4;
}

//------------------------------------------------------------------------------
vtkFlatPieceAlgorithm::vtkFlatPieceAlgorithm()
{
  this->SetTablePort(piecePort);
  this->SetTablePort(curvePort);
  this->Reports = std::make_unique<flattening::bridge::ReportTables>();
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::VisitOptions(flattening::bridge::OptionVisitor& visit)
{
  this->Superclass::VisitOptions(visit);
  visit("SkipClosed", this->SkipClosed);
  visit("CloseCuts", this->CloseCuts);
  visit("Material", this->Material);
  visit("Grain", this->Grain);
  visit("Arrange", this->Arrange);
  visit("Spacing", this->Spacing);
}

//------------------------------------------------------------------------------
vtkFlatPieceAlgorithm::~vtkFlatPieceAlgorithm() = default;

//------------------------------------------------------------------------------
vtkTable* vtkFlatPieceAlgorithm::GetPieces()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(piecePort));
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatPieceAlgorithm::GetCurves()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(curvePort));
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatPieceAlgorithm::GetAngleIterations() const
{
  return this->Reports->angleIterations;
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatPieceAlgorithm::GetIsometricIterations() const
{
  return this->Reports->isometricIterations;
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatPieceAlgorithm::GetReleases() const
{
  return this->Reports->releaseTrials;
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatPieceAlgorithm::GetPieceRemedies() const
{
  return this->Reports->pieceRemedies;
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatPieceAlgorithm::GetLeftOutPieces() const
{
  return this->Reports->leftOutPieces;
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::FinishData(vtkInformationVector* outputVector)
{
  this->Superclass::FinishData(outputVector);
  if (this->IsRefused() && this->GetStatusCode() != NOT_RUN)
  {
    this->Reports = std::make_unique<flattening::bridge::ReportTables>();
    this->SizeWarning.clear();
    std::fill_n(this->Seconds, 4, 0.0);
    flattening::bridge::writeRefusalRow(
      this->GetStatusName(), this->GetStatusMessage(), vtkTable::GetData(outputVector, piecePort));
  }
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::EndRun(vtkDataObject* input, vtkDataObject* output)
{
  if (this->BesideSurface)
  {
    flattening::bridge::layBeside(
      input, output, this->Spacing, flattening::bridge::processesOf(this->GetDistributed()));
  }
}

//------------------------------------------------------------------------------
flattening::FlatteningOptions vtkFlatPieceAlgorithm::Settings()
{
  flattening::FlatteningOptions options = this->OptionsForCore().flattening;
  if (!this->Material.empty())
  {
    options.cloth = flattening::bridge::readCloth(this->Material, this->Grain);
  }
  return options;
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::ListMaterials(vtkTable* materials)
{
  if (materials)
  {
    flattening::bridge::writeMaterials(materials);
  }
}

//------------------------------------------------------------------------------
int vtkFlatPieceAlgorithm::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  flattening::FlatteningOptions options = this->Settings();
  const auto source = this->LoadInput(inputVector);
  if (source && this->Conclude(source->pinVertices(this->Pins, options.conformal.pins)))
  {
    this->Warn(flattening::bridge::describeShortEnds(*source));
    const flattening::FlatteningResult result = flattening::flattenSurface(source->imprinted.mesh,
      source->imprinted.curves, options, flattening::bridge::executionOf(this), this->KeptPieces());
    if (this->Conclude(source->outcomeOfStage(
          result.status, result.status.refused() ? nullptr : result.cut.get())))
    {
      if (!result.leftOut.empty())
      {
        this->Warn({ flattening::bridge::describeLeftOut(*source, result) });
      }
      this->Warn(flattening::bridge::describeVerdicts(*source, result));
      const std::string unit = this->LengthUnitOf(inputVector);
      this->WriteFlattening(*source, result, unit, outputVector);
      if (!unit.empty() && !this->SizeWarning.empty())
      {
        this->Warn({ this->SizeWarning });
      }
    }
  }
  this->WriteRunStatus(vtkPolyData::GetData(outputVector, 0));
  return 1;
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::WriteFlattening(const flattening::bridge::CurvedSurface& source,
  const flattening::FlatteningResult& result, const std::string& unit,
  vtkInformationVector* outputVector)
{
  namespace bridge = flattening::bridge;
  vtkPolyData* const flat = vtkPolyData::GetData(outputVector, 0);
  bridge::writeFlattening(source, result, flat, vtkPolyData::GetData(outputVector, 1),
    vtkPolyData::GetData(outputVector, 2));
  bridge::writePieceTable(source, result, unit, flat, vtkTable::GetData(outputVector, piecePort));
  bridge::writeCurveTable(result.curves, vtkTable::GetData(outputVector, curvePort));
  this->Reports = std::make_unique<bridge::ReportTables>(source, result);
  this->SizeWarning = bridge::sizeWarning(bridge::pieceSizes(result), unit);
  const flattening::StageSeconds& seconds = result.seconds;
  const double all[4] = { seconds.wires, seconds.interior, seconds.quality, seconds.total };
  std::copy_n(all, 4, this->Seconds);
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BesideSurface: " << (this->BesideSurface ? "On" : "Off") << "\n";
  os << indent << "Seconds: " << this->Seconds[3] << "\n";
  os << indent << "SizeWarning: " << this->SizeWarning << "\n";
}
