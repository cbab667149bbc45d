// SPDX-License-Identifier: BSD-3-Clause
#include "ReadSurface.h"

#include "CheckLegacy.h"
#include "InputError.h"
#include "ReadObj.h"
#include "ReadPly.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include <vtkCellArray.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cstdint>
#include <new>

namespace wirewarp
{
namespace
{
/// VTK's legacy reader calls it a warning when data end too early.
bool isFailure(const std::string& warning)
{
  return warning.find("Error reading") != std::string::npos;
}

/// Runs one of VTK's readers; any failure that it reports is a refusal.
template <typename Reader>
vtkSmartPointer<vtkPolyData> runReader(const std::string& path, Reader* reader)
{
  const VtkMessages messages;
  reader->SetFileName(path.c_str());
  try
  {
    reader->Update();
  }
  catch (const std::bad_alloc&)
  {
    throw InputError(
      path, "says that it holds more than memory can; it is damaged or too large, write it again");
  }
  std::string reason = messages.firstError();
  const auto warning =
    std::find_if(messages.warnings().begin(), messages.warnings().end(), isFailure);
  if (reason.empty() && warning != messages.warnings().end())
  {
    reason = *warning;
  }
  if (!reason.empty() || reader->GetErrorCode() != 0)
  {
    throw InputError(path,
      "is damaged, truncated or of another format" + (reason.empty() ? "" : " (" + reason + ")") +
        "; write the file again");
  }
  return reader->GetOutput();
}

/// VTK's reader takes each id on trust.
void checkCells(const std::string& path, vtkPolyData* data)
{
  const vtkIdType pointCount = data->GetNumberOfPoints();
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    if (cells && !cells->IsValid())
    {
      throw InputError(path, "has damaged cells; write the file again");
    }
    for (vtkIdType cell = 0; cells && cell < cells->GetNumberOfCells(); ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(cell, size, ids);
      for (vtkIdType k = 0; k < size; ++k)
      {
        if (ids[k] < 0 || ids[k] >= pointCount)
        {
          throw InputError(path,
            "a cell names point " + std::to_string(ids[k]) + " of " + std::to_string(pointCount) +
              "; ids count from 0");
        }
      }
    }
  }
}

/// A binary STL says how many triangles it has, but VTK's reader is content with fewer.
void checkStlSize(const std::string& path)
{
  const std::string bytes = readWholeFile(path);
  const std::size_t headerSize = 84;
  const std::size_t facetSize = 50;
  const bool text = bytes.compare(0, 5, "solid") == 0 && bytes.find("facet") != std::string::npos;
  if (text)
  {
    if (bytes.find("endsolid") == std::string::npos)
    {
      throw InputError(path, "has no 'endsolid' line; the file is truncated, write it again");
    }
    return;
  }
  std::uint64_t facets = 0;
  for (std::size_t k = 0; k < 4 && bytes.size() >= headerSize; ++k)
  {
    facets |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[80 + k])) << (8 * k);
  }
  if (bytes.size() < headerSize || bytes.size() < headerSize + facetSize * facets)
  {
    throw InputError(
      path, "is shorter than its header says; the file is truncated, write it again");
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> readPolyData(const std::string& path)
{
  const std::string bytes = readWholeFile(path);
  vtkSmartPointer<vtkPolyData> data;
  if (lowerCaseExtension(path) == ".vtp")
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    data = runReader(path, reader.Get());
  }
  else
  {
    checkLegacyPolyData(path, bytes);
    vtkNew<vtkPolyDataReader> reader;
    data = runReader(path, reader.Get());
  }
  checkCells(path, data);
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> readSurface(const std::string& path)
{
  const std::string extension = lowerCaseExtension(path);
  if (extension == ".vtp" || extension == ".vtk")
  {
    return readPolyData(path);
  }
  if (extension == ".obj")
  {
    return readObj(path);
  }
  if (extension == ".ply")
  {
    return readPly(path);
  }
  if (extension == ".stl")
  {
    checkStlSize(path);
    vtkNew<vtkSTLReader> reader;
    return runReader(path, reader.Get());
  }
  throw InputError(path,
    "a surface is read from .vtp, .vtk, .obj, .ply or .stl, not from " +
      (extension.empty() ? std::string("a file without extension") : inQuotes(extension)));
}
}
