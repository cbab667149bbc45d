// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGarmentCodeReader.h"

#include "Base/Memory.h"
#include "Formats/GarmentCodeFile.h"
#include "Formats/GarmentPieces.h"
#include "Input/StatusWords.h"
#include "Outlines/PatternSource.h"
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
  struct Pieces
  {
    Status status;
    pattern::PatternSource source;
  };
  const Pieces pieces = withinMemory([this] {
    Pieces made;
    pattern::Garment garment;
    made.status = this->FileName && *this->FileName
      ? pattern::readGarmentCode(this->FileName, garment)
      : Status{ StatusCode::InvalidPattern, "there is no file name", {},
          { { Remedy::Give, "FileName" } } };
    if (made.status.ok())
    {
      made.status = pattern::makePieces(garment, made.source);
    }
    return made;
  });
  this->StatusName = statusName(pieces.status.code);
  this->ErrorMessage = flattening::inWords(pieces.status);
  if (!pieces.status.ok())
  {
    vtkErrorMacro(<< this->ErrorMessage);
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    return 0; // the pipeline empties the outputs
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  const pattern::GarmentData data = pattern::garmentData(pieces.source);
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
