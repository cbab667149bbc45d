// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FaceSeams.h"

#include <string>

namespace wirewarp
{
/// Reads Wavefront OBJ with coordinates in double precision.
///
/// `v`, `f` (polygons; `v`, `v/vt`, `v//vn`, `v/vt/vn`; negative ids count from the end), `l` and
/// `vt` are read, of `g`, `o` and `usemtl` the names, of which the first two give type and name to
/// the lines below them: "dart left", see CurveList.h. Edges without a face, which modellers write
/// as lines of two points in an object that has faces, are left out. A comment may state the unit
/// ("# units: mm"). The surface has the cell array `PieceName` where pieceNames() has names.
/// Everything else is passed over. Point k is the k-th `v` line: texture seams split nothing.
/// Throws InputError with file and line.
SurfaceContents readObj(const std::string& path);
}
