// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLeastSquaresConformalFilter.h"

#include "Flattening/SurfaceFlattening.h"
#include "OptionVisitor.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkLeastSquaresConformalFilter);

//------------------------------------------------------------------------------
vtkLeastSquaresConformalFilter::vtkLeastSquaresConformalFilter()
{
  flattening::bridge::OptionVisitor visit =
    flattening::bridge::defaultsOf(flattening::OptionOwner::Conformal);
  this->VisitOwnOptions(visit);
}

//------------------------------------------------------------------------------
void vtkLeastSquaresConformalFilter::VisitOptions(flattening::bridge::OptionVisitor& visit)
{
  this->Superclass::VisitOptions(visit);
  this->VisitOwnOptions(visit);
}

//------------------------------------------------------------------------------
vtkLeastSquaresConformalFilter::~vtkLeastSquaresConformalFilter() = default;

//------------------------------------------------------------------------------
int vtkLeastSquaresConformalFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  flattening::FlatteningOptions options = this->OptionsForCore().flattening;
  options.scheme = flattening::Scheme::LeastSquaresConformal;
  this->Flatten(inputVector, outputVector, options, this->Pins);
  return 1;
}

//------------------------------------------------------------------------------
void vtkLeastSquaresConformalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  flattening::bridge::OptionVisitor print =
    flattening::bridge::printerOf(flattening::OptionOwner::Conformal, os, indent);
  this->VisitOwnOptions(print);
}
