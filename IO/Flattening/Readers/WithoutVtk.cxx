// SPDX-License-Identifier: BSD-3-Clause
// Stands in for ReadVtk.cxx in builds without VTK.
#include "InputError.h"
#include "ReadVtk.h"
#include "TextFile.h"

namespace wirewarp
{
DataSet readVtk(const std::string& path)
{
  checkedFileSize(path);
  throw InputError(path,
    inQuotes(lowerCaseExtension(path)) +
      " is read by builds with VTK alone, such as Debian's package; save it as .obj, .ply, .stl or "
      ".off, curves as .obj, .dxf, .csv or text");
}
}
