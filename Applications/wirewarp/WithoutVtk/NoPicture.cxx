// SPDX-License-Identifier: BSD-3-Clause
// Stands in for Vtk/Picture.cxx in builds without VTK.
#include "InputError.h"
#include "Picture.h"

#include <CLI/CLI.hpp>

namespace wirewarp
{
void addPicture(CLI::App& app, PictureRequest& request)
{
  static_cast<void>(request);
  app.footer("Pictures are drawn by builds with VTK alone.");
}

void checkPicture(const PictureRequest& request)
{
  if (request.any())
  {
    throw InputError(request.path,
      "pictures are drawn by builds with VTK alone, such as Debian's package; draw the pattern "
      "instead (wirewarp pattern -o FILE.svg)");
  }
}

void addPicture(const Options& options, const Flattening& result, OutputFiles& files)
{
  static_cast<void>(options);
  static_cast<void>(result);
  static_cast<void>(files);
}
}
