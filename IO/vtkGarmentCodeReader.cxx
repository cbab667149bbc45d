// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGarmentCodeReader.h"

#include "Formats/GarmentCodeFile.h"
#include "Input/StatusWords.h"
#include "PolyDataSets.h"

#include "vtkErrorCode.h"
#include "vtkFlatteningAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <array>
#include <fstream>

vtkStandardNewMacro(vtkGarmentCodeReader);

//------------------------------------------------------------------------------
vtkGarmentCodeReader::vtkGarmentCodeReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkGarmentCodeReader::~vtkGarmentCodeReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkGarmentCodeReader::CanReadFile(const char* name)
{
  if (!name || !*name)
  {
    return 0;
  }
  constexpr std::size_t looked = 1'000'000;
  std::string text(looked, '\0');
  std::ifstream file(name, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(looked));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text.find("\"panels\"") != std::string::npos ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkGarmentCodeReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  using namespace flattening;
  pattern::GarmentData data;
  const Status status = this->FileName && *this->FileName
    ? pattern::readGarmentCode(this->FileName, data)
    : Status{ StatusCode::InvalidPattern, "there is no file name", {},
        { { Remedy::Give, "FileName" } } };
  this->StatusName = statusName(status.code);
  this->ErrorMessage = flattening::inWords(status);
  if (!status.ok())
  {
    vtkErrorMacro(<< this->ErrorMessage);
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    return 0; // the pipeline empties the outputs
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  const std::array<const DataSet*, 3> parts{ &data.flat, &data.wires, &data.cut };
  for (int port = 0; port < 3; ++port)
  {
    bridge::fill(vtkPolyData::GetData(outputVector, port), *parts[static_cast<std::size_t>(port)]);
    vtkFlatteningAlgorithm::SetLengthUnitOf(vtkPolyData::GetData(outputVector, port), "cm");
  }
  vtkPolyData::GetData(outputVector, 1)
    ->SetPoints(vtkPolyData::GetData(outputVector, 0)->GetPoints());
  return 1;
}

//------------------------------------------------------------------------------
void vtkGarmentCodeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "StatusName: " << this->StatusName << "\n";
}
