// SPDX-License-Identifier: BSD-3-Clause
// Stands in for Vtk/WriteVtp.cxx in builds without VTK.
#include "InputError.h"
#include "TextFile.h"
#include "WriteData.h"

namespace wirewarp
{
const char* const dataExtension = ".obj";

std::string vtkInWords()
{
  return "without VTK";
}

std::vector<std::string> bytesOf(const std::vector<NamedData>& files, const flattening::Execution&)
{
  std::vector<std::string> bytes;
  for (const auto& [file, data] : files)
  {
    if (lowerCaseExtension(file) == ".vtp")
    {
      throw InputError(file,
        "'.vtp' is written by builds with VTK alone, such as Debian's package; name a file in "
        ".obj");
    }
    bytes.push_back(objOf(*data));
  }
  return bytes;
}
}
