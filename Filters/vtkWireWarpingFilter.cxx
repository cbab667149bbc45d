// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWireWarpingFilter.h"

#include "Flattening/SurfaceFlattening.h"
#include "ListChanges.h"
#include "Options/OptionStructures.h"
#include "Options/OptionValues.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkWireWarpingFilter);

//------------------------------------------------------------------------------
vtkWireWarpingFilter::vtkWireWarpingFilter()
{
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::UsePaperMethod()
{
  this->SetScheme(GLOBAL);
  this->SetInterior(LAPLACIAN);
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::AddCurveEase(const std::string& curve, int piece, double fraction)
{
  flattening::bridge::changeEntry(
    this, this->Eases, std::make_pair(curve, std::max(piece, -1)), fraction);
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::RemoveAllCurveEases()
{
  flattening::bridge::changeToNone(this, this->Eases);
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::SetWeightArray(const char* name)
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name ? name : "");
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::AddOtherOptions(flattening::OptionValues& values)
{
  this->Superclass::AddOtherOptions(values);
  values.set("WeightArray", std::string(this->GetWeightArray()));
}

//------------------------------------------------------------------------------
flattening::FlatteningOptions vtkWireWarpingFilter::Settings()
{
  static_assert(static_cast<int>(flattening::Scheme::Progressive) == PROGRESSIVE, "");
  static_assert(static_cast<int>(flattening::Scheme::Isometric) == ISOMETRIC, "");
  static_assert(static_cast<int>(flattening::AngleMethod::Sequential) == SEQUENTIAL, "");
  static_assert(
    static_cast<int>(flattening::InteriorMethod::AsRigidAsPossible) == AS_RIGID_AS_POSSIBLE, "");
  static_assert(
    static_cast<int>(flattening::DistortionEnergyKind::Automatic) == AUTOMATIC_ENERGY, "");
  static_assert(static_cast<int>(flattening::BoundaryMode::Free) == FREE_BOUNDARY, "");
  static_assert(static_cast<int>(flattening::DartLegs::Mirrored) == MIRRORED, "");

  flattening::FlatteningOptions options = this->Superclass::Settings();
  for (const auto& [place, fraction] : this->Eases)
  {
    options.eases.push_back({ place.first, place.second, fraction });
  }
  return options;
}

//------------------------------------------------------------------------------
void vtkWireWarpingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& [place, fraction] : this->Eases)
  {
    os << indent << "CurveEase " << place.first << " in piece " << place.second << ": " << fraction
       << "\n";
  }
}
