// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FaceSeams.h"

#include <string>

namespace wirewarp
{
struct SurfaceContents
{
  DataSet surface;        ///< of .vtp and .vtk with the polylines among its cells
  DataSet curves;         ///< of .obj, over the same points
  std::string unit = {};  ///< that the file states, as in Units.h; empty: none
  FaceLabels labels = {}; ///< of the faces of .obj
  bool doubled = false;   ///< the format doubles points along texture seams, which are to be joined
};

/// Reads a surface by its extension: .vtp .vtk .obj .ply .stl .off .gltf .glb. Throws InputError.
SurfaceContents readSurface(const std::string& path);
}
