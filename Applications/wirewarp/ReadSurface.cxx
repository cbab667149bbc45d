// SPDX-License-Identifier: BSD-3-Clause
#include "ReadSurface.h"

#include "InputError.h"
#include "ReadObj.h"
#include "ReadPly.h"
#include "ReadVtk.h"
#include "TextFile.h"

namespace wirewarp
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> readSurface(const std::string& path)
{
  const std::string extension = lowerCaseExtension(path);
  if (extension == ".vtp" || extension == ".vtk" || extension == ".stl")
  {
    return readVtk(path);
  }
  if (extension == ".obj")
  {
    return readObj(path);
  }
  if (extension == ".ply")
  {
    return readPly(path);
  }
  throw InputError(path,
    "a surface is read from .vtp, .vtk, .obj, .ply or .stl, not from " +
      (extension.empty() ? std::string("a file without extension") : inQuotes(extension)));
}
}
