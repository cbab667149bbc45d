// SPDX-License-Identifier: BSD-3-Clause
#include "ReadSurface.h"

#include "InputError.h"
#include "ReadObj.h"
#include "ReadOff.h"
#include "ReadPly.h"
#include "ReadStl.h"
#include "ReadVtk.h"
#include "TextFile.h"
#include "Units.h"

namespace wirewarp
{
SurfaceContents readSurface(const std::string& path)
{
  const std::string extension = lowerCaseExtension(path);
  if (extension == ".vtp" || extension == ".vtk")
  {
    SurfaceContents contents{ readVtk(path), {} };
    contents.unit = unitOf(contents.surface);
    return contents;
  }
  if (extension == ".obj")
  {
    return readObj(path);
  }
  if (extension == ".gltf" || extension == ".glb")
  {
    // The format knows metres only, and no points that triangles of two textures share.
    SurfaceContents contents{ readVtk(path), {}, "m" };
    contents.doubled = true;
    return contents;
  }
  if (extension == ".off")
  {
    return { readOff(path), {} };
  }
  if (extension == ".stl")
  {
    return { readStl(path), {} };
  }
  if (extension == ".3mf")
  {
    throw InputError(path, "3MF is not read; save the surface as .obj, .ply, .glb or .stl");
  }
  if (extension == ".ply")
  {
    return { readPly(path), {} };
  }
  checkedFileSize(path); // a folder or a file that is not there has no format
  throw InputError(path,
    "a surface is read from .vtp, .vtk, .obj, .ply, .stl, .off, .gltf or .glb, not from " +
      (extension.empty() ? std::string("a file without extension") : inQuotes(extension)));
}
}
