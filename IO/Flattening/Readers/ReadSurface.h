// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FaceSeams.h"

#include <string>

namespace wirewarp
{
/// Reads a surface by its extension: .vtp .vtk .obj .ply .stl .off .gltf .glb. Throws InputError.
SurfaceContents readSurface(const std::string& path);
}
