// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKeyCurvePrices.h"

#include "AttributeArrays.h"
#include "CurvedPolyData.h"
#include "Design/KeyPrices.h"
#include "FilterExecution.h"
#include "Flattening/FlatteningOptions.h"
#include "Report/KeyPriceReport.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkKeyCurvePrices);

namespace
{
constexpr int pricePort = 5;
}

//------------------------------------------------------------------------------
vtkKeyCurvePrices::vtkKeyCurvePrices()
{
  this->SetTablePort(pricePort);
}

//------------------------------------------------------------------------------
int vtkKeyCurvePrices::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  flattening::KeyPrices prices;
  const auto source = this->LoadInput(inputVector);
  bool done = false;
  if (source)
  {
    prices = flattening::priceKeys(source->imprinted.mesh, source->imprinted.curves,
      this->Settings(), flattening::bridge::executionOf(this));
    done = this->Conclude(source->outcomeOfStage(prices.status));
  }
  if (!done)
  {
    this->WriteRunStatus(vtkPolyData::GetData(outputVector, 0));
    return 1;
  }
  this->Superclass::RequestData(request, inputVector, outputVector);
  if (!this->IsRefused())
  {
    flattening::bridge::writeTable(flattening::keyPriceTable(source->imprinted.curves, prices),
      vtkTable::GetData(outputVector, pricePort));
  }
  return 1;
}
