// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLeastSquaresConformalFilter.h"

#include "Flattening/SurfaceFlattening.h"
#include "OptionVisitor.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLeastSquaresConformalFilter);

//------------------------------------------------------------------------------
vtkLeastSquaresConformalFilter::vtkLeastSquaresConformalFilter()
{
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkLeastSquaresConformalFilter::VisitOptions(flattening::bridge::OptionVisitor& visit)
{
  this->Superclass::VisitOptions(visit);
  visit("AreaNormalized", this->AreaNormalized);
  visit("Pins", this->Pins);
}

//------------------------------------------------------------------------------
flattening::FlatteningOptions vtkLeastSquaresConformalFilter::Settings()
{
  flattening::FlatteningOptions options = this->Superclass::Settings();
  options.scheme = flattening::Scheme::LeastSquaresConformal;
  return options;
}
