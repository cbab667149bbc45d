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
SurfaceContents readSurface(const std::string& path)
{
  const std::string extension = lowerCaseExtension(path);
  if (extension == ".vtp" || extension == ".vtk" || extension == ".stl")
  {
    return { readVtk(path), nullptr };
  }
  if (extension == ".obj")
  {
    const ObjContents contents = readObj(path);
    return { contents.surface, contents.curves };
  }
  if (extension == ".ply")
  {
    return { readPly(path), nullptr };
  }
  throw InputError(path,
    "a surface is read from .vtp, .vtk, .obj, .ply or .stl, not from " +
      (extension.empty() ? std::string("a file without extension") : inQuotes(extension)));
}
}
