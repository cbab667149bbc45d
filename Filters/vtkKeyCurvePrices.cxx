// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKeyCurvePrices.h"

#include "AttributeArrays.h"
#include "CurvedPolyData.h"
#include "FilterExecution.h"
#include "Flattening/FlatteningOptions.h"
#include "Report/FlatteningRun.h"
#include "Report/FlatteningTables.h"

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
int vtkKeyCurvePrices::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  if (const auto source = this->LoadInput(inputVector))
  {
    const flattening::FlatteningOptions options = this->Settings();
    flattening::FlatteningRun run(*source);
    const flattening::Execution execution = flattening::bridge::executionOf(this);
    std::optional<flattening::KeyPrices> prices;
    if (this->Weigh(run, *source))
    {
      prices = run.price(options, execution);
    }
    const auto result =
      prices ? run.flatten(options, { -1, -1 }, execution, this->KeptPieces()) : std::nullopt;
    if (this->TakeResult(
          run, *source, result ? &*result : nullptr, options, inputVector, outputVector))
    {
      flattening::bridge::writeTable(flattening::keyPriceTable(source->imprinted.curves, *prices),
        vtkTable::GetData(outputVector, pricePort));
    }
  }
  this->WriteRunStatus(vtkPolyData::GetData(outputVector, 0));
  return 1;
}
