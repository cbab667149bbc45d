// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWireWarpingFilter.h"

#include "ClothInput.h"
#include "CurveFractions.h"
#include "Flattening/SurfaceFlattening.h"
#include "ListChanges.h"
#include "OptionVisitor.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkWireWarpingFilter);

//------------------------------------------------------------------------------
vtkWireWarpingFilter::vtkWireWarpingFilter()
{
  flattening::bridge::OptionVisitor visit =
    flattening::bridge::defaultsOf(flattening::OptionOwner::Warping);
  this->VisitOwnOptions(visit);
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::VisitOptions(flattening::bridge::OptionVisitor& visit)
{
  this->Superclass::VisitOptions(visit);
  this->VisitOwnOptions(visit);
}

//------------------------------------------------------------------------------
vtkWireWarpingFilter::~vtkWireWarpingFilter() = default;

//------------------------------------------------------------------------------
const char* vtkWireWarpingFilter::GetSchemeAsString() const
{
  return flattening::bridge::nameOf(flattening::OptionOwner::Warping, "Scheme", this->Scheme);
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::UsePaperMethod()
{
  this->SetScheme(GLOBAL);
  this->SetInterior(LAPLACIAN);
}

//------------------------------------------------------------------------------
const char* vtkWireWarpingFilter::GetSolverAsString() const
{
  return flattening::bridge::nameOf(flattening::OptionOwner::Warping, "Solver", this->Solver);
}

//------------------------------------------------------------------------------
const char* vtkWireWarpingFilter::GetInteriorAsString() const
{
  return flattening::bridge::nameOf(flattening::OptionOwner::Warping, "Interior", this->Interior);
}

//------------------------------------------------------------------------------
const char* vtkWireWarpingFilter::GetDistortionEnergyAsString() const
{
  return flattening::bridge::nameOf(
    flattening::OptionOwner::Warping, "DistortionEnergy", this->DistortionEnergy);
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::SetMaterial(const char* text)
{
  if (flattening::bridge::change(this->Material, std::string(text ? text : "")))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::SetGrain(const char* text)
{
  if (flattening::bridge::change(this->Grain, std::string(text ? text : "")))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::AddCurveEase(const std::string& curve, int piece, double fraction)
{
  const flattening::bridge::CurveFraction added{ curve, std::max(piece, -1), fraction };
  const auto same = std::find_if(this->Eases.begin(), this->Eases.end(),
    [&added](const auto& ease) { return ease.curve == added.curve && ease.piece == added.piece; });
  if (same == this->Eases.end())
  {
    this->Eases.push_back(added);
    this->Modified();
  }
  else if (flattening::bridge::change(*same, added))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::RemoveAllCurveEases()
{
  if (flattening::bridge::changeToNone(this->Eases))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::SetCurveEases(const char* text)
{
  std::vector<flattening::bridge::CurveFraction> eases;
  if (!flattening::bridge::readFractions(text ? text : "", true, eases))
  {
    vtkErrorMacro("\"" << text << "\" is not NAME:PIECE=PERCENT%, with pieces from 1 and less than "
                       << "100 %, several separated by semicolons.");
    return;
  }
  if (flattening::bridge::change(this->Eases, eases))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkWireWarpingFilter::GetCurveEases() const
{
  this->CurveEasesText = flattening::bridge::fractionsText(this->Eases, true);
  return this->CurveEasesText.c_str();
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::SetCurveTolerances(const char* text)
{
  std::vector<flattening::bridge::CurveFraction> tolerances;
  if (!flattening::bridge::readFractions(text ? text : "", false, tolerances))
  {
    vtkErrorMacro("\"" << text << "\" is not NAME=PERCENT% with a percentage from 0 and below 100, "
                       << "several separated by semicolons.");
    return;
  }
  std::map<std::string, double> byName;
  for (const flattening::bridge::CurveFraction& tolerance : tolerances)
  {
    byName[tolerance.curve] = tolerance.fraction;
  }
  if (flattening::bridge::change(this->CurveTolerances, byName))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkWireWarpingFilter::GetCurveTolerances() const
{
  std::vector<flattening::bridge::CurveFraction> tolerances;
  for (const auto& [curve, tolerance] : this->CurveTolerances)
  {
    tolerances.push_back({ curve, -1, tolerance });
  }
  this->CurveTolerancesText = flattening::bridge::fractionsText(tolerances, false);
  return this->CurveTolerancesText.c_str();
}

//------------------------------------------------------------------------------
const char* vtkWireWarpingFilter::GetDartLegsAsString() const
{
  return flattening::bridge::nameOf(flattening::OptionOwner::Warping, "DartLegs", this->DartLegs);
}

//------------------------------------------------------------------------------
flattening::FlatteningOptions vtkWireWarpingFilter::Settings()
{
  static_assert(static_cast<int>(flattening::Scheme::Progressive) == PROGRESSIVE, "");
  static_assert(
    static_cast<int>(flattening::Scheme::LeastSquaresConformal) == LEAST_SQUARES_CONFORMAL, "");
  static_assert(static_cast<int>(flattening::AngleMethod::Sequential) == SEQUENTIAL, "");
  static_assert(
    static_cast<int>(flattening::InteriorMethod::AsRigidAsPossible) == AS_RIGID_AS_POSSIBLE, "");
  static_assert(
    static_cast<int>(flattening::DistortionEnergyKind::SymmetricDirichlet) == SYMMETRIC_DIRICHLET,
    "");
  static_assert(static_cast<int>(flattening::DartLegs::Mirrored) == MIRRORED, "");

  flattening::FlatteningOptions options = this->OptionsForCore().flattening;
  if (!this->Material.empty())
  {
    options.cloth = flattening::bridge::readCloth(this->Material, this->Grain);
  }
  for (const auto& ease : this->Eases)
  {
    options.eases.push_back({ ease.curve, ease.piece, ease.fraction });
  }
  return options;
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::ListMaterials(vtkTable* materials)
{
  if (materials)
  {
    flattening::bridge::writeMaterials(materials);
  }
}

//------------------------------------------------------------------------------
int vtkWireWarpingFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Flatten(inputVector, outputVector, this->Settings(), this->ConformalPins);
  return 1;
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  flattening::bridge::OptionVisitor print =
    flattening::bridge::printerOf(flattening::OptionOwner::Warping, os, indent);
  this->VisitOwnOptions(print);
  for (const auto& ease : this->Eases)
  {
    os << indent << "CurveEase " << ease.curve << " in piece " << ease.piece << ": "
       << ease.fraction << "\n";
  }
}
