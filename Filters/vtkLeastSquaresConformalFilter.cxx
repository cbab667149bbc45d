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
  this->SetNumberOfOutputPorts(3);
  const flattening::FlatteningOptions defaults;
  this->AreaNormalized = defaults.conformal.areaNormalized;
  this->SkipClosed = defaults.skipClosed;
  this->Arrange = defaults.arrange;
  this->Spacing = defaults.spacing;
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
  options.skipClosed = this->SkipClosed;
  options.arrange = this->Arrange;
  options.spacing = this->Spacing;
  this->Flatten(inputVector, outputVector, options, this->Pins);
  return 1;
}

//------------------------------------------------------------------------------
void vtkLeastSquaresConformalFilter::EndRun(vtkDataObject* input, vtkDataObject* output)
{
  if (this->BesideSurface)
  {
    this->LayBeside(input, output, this->Spacing);
  }
}

//------------------------------------------------------------------------------
void vtkLeastSquaresConformalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pins: " << this->Pins[0] << " " << this->Pins[1] << "\n";
  os << indent << "AreaNormalized: " << (this->AreaNormalized ? "On" : "Off") << "\n";
  os << indent << "SkipClosed: " << (this->SkipClosed ? "On" : "Off") << "\n";
  os << indent << "Arrange: " << (this->Arrange ? "On" : "Off") << "\n";
  os << indent << "BesideSurface: " << (this->BesideSurface ? "On" : "Off") << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
}
