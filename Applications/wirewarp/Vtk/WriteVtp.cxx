// SPDX-License-Identifier: BSD-3-Clause
#include "InputError.h"
#include "PolyDataOutput.h"
#include "TextFile.h"
#include "VtkMessages.h"
#include "WriteData.h"

#include <vtkNew.h>
#include <vtkSMPTools.h>
#include <vtkVersion.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstddef>
#include <new>

namespace wirewarp
{
namespace
{
bool isObj(const NamedData& file)
{
  return lowerCaseExtension(file.file) == ".obj";
}

/// Where VTK's writer finds no memory it crashes, so that it is asked for here first.
void demandMemory(const std::vector<NamedData>& files)
{
  constexpr std::size_t slack = std::size_t{ 1 } << 24U;
  constexpr std::size_t copies = 4; // the data set, its blocks as they are, packed and as text
  std::size_t values = 0;
  for (const NamedData& file : files)
  {
    const flattening::DataSet& data = *file.data;
    values += 3 * data.points->size() + data.lines.ids.size() + data.faces.ids.size();
    for (const flattening::Columns* const columns : { &data.pointArrays, &data.cellArrays })
    {
      for (const flattening::Column& column : *columns)
      {
        values += column.rows() * static_cast<std::size_t>(column.components);
      }
    }
  }
  ::operator delete(::operator new(copies * sizeof(double) * values + slack));
}

/// Empty where VTK does not write it.
std::string vtpOf(const flattening::DataSet& data)
{
  // By way of memory: on a full disk VTK's writer of files crashes.
  vtkNew<vtkXMLPolyDataWriter> writer;
  // With the Expat of Debian 12's security updates ParaView 5.11 refuses appended data.
  writer->SetDataModeToBinary();
  // Zlib takes three times as long to make files of seven tenths of the size.
  writer->SetCompressorTypeToLZ4();
  writer->WriteToOutputStringOn();
  writer->SetInputData(polyDataOf(data));
  return writer->Write() == 1 ? writer->GetOutputString() : std::string();
}
}

const char* const dataExtension = ".vtp";

std::string vtkInWords()
{
  return std::string("VTK ") + vtkVersion::GetVTKVersion();
}

std::vector<std::string> bytesOf(
  const std::vector<NamedData>& files, const flattening::Execution& execution)
{
  vtkSMPTools::SetBackend("Sequential"); // where there can be no thread, TBB gives up
  const VtkMessages messages;
  demandMemory(files);
  std::vector<std::string> bytes(files.size());
  execution.forEachTask(static_cast<flattening::Index>(files.size()), [&](flattening::Index k) {
    bytes[k] = isObj(files[k]) ? objOf(*files[k].data) : vtpOf(*files[k].data);
  });
  for (std::size_t k = 0; k < files.size(); ++k)
  {
    if ((bytes[k].empty() && !isObj(files[k])) || !messages.errors().empty())
    {
      throw InputError(files[k].file, "cannot be written (" + messages.firstError() + ")");
    }
  }
  return bytes;
}
}
