// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <string>

namespace wirewarp
{
/// Reads PLY, ASCII and binary of both byte orders: x, y, z of the element `vertex` and the list
/// `vertex_indices` (or `vertex_index`) of the elements `face` and `tristrips`; everything else is
/// passed over.
/// Coordinates keep the file's precision, `double` too. Throws InputError.
DataSet readPly(const std::string& path);
}
