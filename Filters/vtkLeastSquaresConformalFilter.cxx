// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLeastSquaresConformalFilter.h"

#include "Flattening/SurfaceFlattening.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkLeastSquaresConformalFilter);

//------------------------------------------------------------------------------
vtkLeastSquaresConformalFilter::vtkLeastSquaresConformalFilter()
{
  this->AreaNormalized = flattening::FlatteningOptions().conformal.areaNormalized;
}

//------------------------------------------------------------------------------
vtkLeastSquaresConformalFilter::~vtkLeastSquaresConformalFilter() = default;

//------------------------------------------------------------------------------
int vtkLeastSquaresConformalFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  flattening::FlatteningOptions options;
  options.scheme = flattening::Scheme::LeastSquaresConformal;
  options.conformal.areaNormalized = this->AreaNormalized;
  this->ApplyPieceOptions(options);
  this->Flatten(inputVector, outputVector, options, this->Pins);
  return 1;
}

//------------------------------------------------------------------------------
void vtkLeastSquaresConformalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pins: " << this->Pins[0] << " " << this->Pins[1] << "\n";
  os << indent << "AreaNormalized: " << (this->AreaNormalized ? "On" : "Off") << "\n";
}
