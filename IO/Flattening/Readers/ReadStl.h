// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <string>

namespace wirewarp
{
/// Reads STL, binary and ASCII. Coordinates have the single precision of the format; points in one
/// place are one, and triangles of which two corners are one are left out. Throws InputError.
DataSet readStl(const std::string& path);
}
