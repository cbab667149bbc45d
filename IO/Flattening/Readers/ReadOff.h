// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <string>

namespace wirewarp
{
/// Reads OFF, the Object File Format of Geomview, as text with each vertex and each face in a line
/// of its own; colors, normals and texture (COFF, NOFF, STOFF) are passed over. Throws InputError
/// with file and line.
DataSet readOff(const std::string& path);
}
