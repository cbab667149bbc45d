// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWireWarpingFilter.h"

#include "ClothInput.h"
#include "CurveFractions.h"
#include "Flattening/SurfaceFlattening.h"
#include "ListChanges.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkWireWarpingFilter);

//------------------------------------------------------------------------------
vtkWireWarpingFilter::vtkWireWarpingFilter()
{
  const flattening::FlatteningOptions defaults;
  this->Scheme = static_cast<int>(defaults.scheme);
  this->Solver = static_cast<int>(defaults.angles.method);
  this->MaximumIterations = defaults.angles.maximumIterations;
  this->ClosureTolerance = defaults.angles.closureTolerance;
  this->OptimalityTolerance = defaults.angles.optimalityTolerance;
  this->Interior = static_cast<int>(defaults.interior.method);
  this->RelaxationFactor = defaults.interior.relaxation;
  this->RelaxationMovement = defaults.interior.movement;
  this->RelaxationMinimumIterations = defaults.interior.minimumIterations;
  this->RelaxationMaximumIterations = defaults.interior.maximumIterations;
  this->RigidEnergyTolerance = defaults.interior.energyTolerance;
  this->RigidMaximumIterations = defaults.interior.maximumRigidIterations;
  this->DistortionEnergy = static_cast<int>(defaults.isometric.energy.kind);
  this->AreaBias = defaults.isometric.energy.bias;
  this->AngleWeight = defaults.isometric.angleWeight;
  this->IsometricMaximumIterations = defaults.isometric.maximumIterations;
  this->IsometricTolerance = defaults.isometric.tolerance;
  for (int pin = 0; pin < 2; ++pin)
  {
    this->ConformalPins[pin] = defaults.conformal.pins[pin];
  }
  this->CloseCuts = defaults.closeCuts;
  this->DartLegs = static_cast<int>(defaults.dartLegs);
  this->ReleaseKeys = defaults.releaseKeys;
  this->ReleaseTrials = defaults.tryReleases;
  this->MaximumLengthError = defaults.lengthTolerance;
}

//------------------------------------------------------------------------------
vtkWireWarpingFilter::~vtkWireWarpingFilter() = default;

//------------------------------------------------------------------------------
const char* vtkWireWarpingFilter::GetSchemeAsString() const
{
  static const char* const names[] = { "Progressive", "Global", "Isometric",
    "LeastSquaresConformal" };
  return names[this->Scheme];
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
  static const char* const names[] = { "Newton", "Sequential" };
  return names[this->Solver];
}

//------------------------------------------------------------------------------
const char* vtkWireWarpingFilter::GetInteriorAsString() const
{
  static const char* const names[] = { "Laplacian", "Relaxation", "AsRigidAsPossible" };
  return names[this->Interior];
}

//------------------------------------------------------------------------------
const char* vtkWireWarpingFilter::GetDistortionEnergyAsString() const
{
  static const char* const names[] = { "Rigid", "SymmetricDirichlet" };
  return names[this->DistortionEnergy];
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
  static const char* const names[] = { "Free", "Straight", "Mirrored" };
  return names[this->DartLegs];
}

//------------------------------------------------------------------------------
flattening::FlatteningOptions vtkWireWarpingFilter::Settings() const
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

  flattening::FlatteningOptions options;
  options.scheme = static_cast<flattening::Scheme>(this->Scheme);
  options.angles.method = static_cast<flattening::AngleMethod>(this->Solver);
  options.angles.maximumIterations = this->MaximumIterations;
  options.angles.closureTolerance = this->ClosureTolerance;
  options.angles.optimalityTolerance = this->OptimalityTolerance;
  options.interior.method = static_cast<flattening::InteriorMethod>(this->Interior);
  options.interior.relaxation = this->RelaxationFactor;
  options.interior.movement = this->RelaxationMovement;
  options.interior.minimumIterations = this->RelaxationMinimumIterations;
  options.interior.maximumIterations = this->RelaxationMaximumIterations;
  options.interior.energyTolerance = this->RigidEnergyTolerance;
  options.interior.maximumRigidIterations = this->RigidMaximumIterations;
  options.isometric.energy.kind =
    static_cast<flattening::DistortionEnergyKind>(this->DistortionEnergy);
  options.isometric.energy.bias = this->AreaBias;
  options.isometric.angleWeight = this->AngleWeight;
  options.isometric.maximumIterations = this->IsometricMaximumIterations;
  options.isometric.tolerance = this->IsometricTolerance;
  if (!this->Material.empty())
  {
    options.cloth = flattening::bridge::readCloth(this->Material, this->Grain);
  }
  options.closeCuts = this->CloseCuts;
  for (const auto& ease : this->Eases)
  {
    options.eases.push_back({ ease.curve, ease.piece, ease.fraction });
  }
  options.dartLegs = static_cast<flattening::DartLegs>(this->DartLegs);
  options.releaseKeys = this->ReleaseKeys;
  options.tryReleases = this->ReleaseTrials;
  this->ApplyPieceOptions(options);
  options.lengthTolerance = this->MaximumLengthError;
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
  os << indent << "Scheme: " << this->GetSchemeAsString() << "\n";
  os << indent << "Solver: " << this->GetSolverAsString() << "\n";
  os << indent << "Interior: " << this->GetInteriorAsString() << "\n";
  os << indent << "ReleaseKeys: " << (this->ReleaseKeys ? "On" : "Off") << "\n";
  os << indent << "ReleaseTrials: " << (this->ReleaseTrials ? "On" : "Off") << "\n";
  os << indent << "CloseCuts: " << (this->CloseCuts ? "On" : "Off") << "\n";
  os << indent << "DartLegs: " << this->GetDartLegsAsString() << "\n";
  for (const auto& ease : this->Eases)
  {
    os << indent << "CurveEase " << ease.curve << " in piece " << ease.piece << ": "
       << ease.fraction << "\n";
  }
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "ClosureTolerance: " << this->ClosureTolerance << "\n";
  os << indent << "OptimalityTolerance: " << this->OptimalityTolerance << "\n";
  os << indent << "RelaxationFactor: " << this->RelaxationFactor << "\n";
  os << indent << "RelaxationMovement: " << this->RelaxationMovement << "\n";
  os << indent << "RelaxationMinimumIterations: " << this->RelaxationMinimumIterations << "\n";
  os << indent << "RelaxationMaximumIterations: " << this->RelaxationMaximumIterations << "\n";
  os << indent << "RigidEnergyTolerance: " << this->RigidEnergyTolerance << "\n";
  os << indent << "RigidMaximumIterations: " << this->RigidMaximumIterations << "\n";
  os << indent << "DistortionEnergy: " << this->GetDistortionEnergyAsString() << "\n";
  os << indent << "AreaBias: " << this->AreaBias << "\n";
  os << indent << "AngleWeight: " << this->AngleWeight << "\n";
  os << indent << "IsometricMaximumIterations: " << this->IsometricMaximumIterations << "\n";
  os << indent << "IsometricTolerance: " << this->IsometricTolerance << "\n";
  os << indent << "Material: " << this->Material << "\n";
  os << indent << "Grain: " << this->Grain << "\n";
  os << indent << "ConformalPins: " << this->ConformalPins[0] << " " << this->ConformalPins[1]
     << "\n";
  os << indent << "MaximumLengthError: " << this->MaximumLengthError << "\n";
}
