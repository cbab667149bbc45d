// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLeastSquaresConformalFilter.h"

#include "Flattening/SurfaceFlattening.h"
#include "Options/OptionStructures.h"
#include "Options/OptionValues.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLeastSquaresConformalFilter);

//------------------------------------------------------------------------------
vtkLeastSquaresConformalFilter::vtkLeastSquaresConformalFilter()
{
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkLeastSquaresConformalFilter::AddOtherOptions(flattening::OptionValues& values)
{
  this->Superclass::AddOtherOptions(values);
  values.set("Pins",
    std::vector<double>{ static_cast<double>(this->Pins[0]), static_cast<double>(this->Pins[1]) });
}

//------------------------------------------------------------------------------
flattening::FlatteningOptions vtkLeastSquaresConformalFilter::Settings()
{
  flattening::FlatteningOptions options = this->Superclass::Settings();
  options.scheme = flattening::Scheme::LeastSquaresConformal;
  return options;
}
