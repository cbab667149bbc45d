// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FaceSeams.h"

#include <string>

namespace wirewarp
{
/// What an OBJ file holds, over one list of points.
struct ObjContents
{
  /// Its faces, where pieceNames() has names with the cell array `PieceName`.
  DataSet surface;
  DataSet curves;   ///< its line elements
  std::string unit; ///< that a comment states, as in Units.h; empty: none
  FaceLabels labels;
};

/// Reads Wavefront OBJ with coordinates in double precision.
///
/// `v`, `f` (polygons; `v`, `v/vt`, `v//vn`, `v/vt/vn`; negative ids count from the end), `l` and
/// `vt` are read, of `g`, `o` and `usemtl` the names, of which the first two give type and name to
/// the lines below them: "dart left", see CurveList.h; a comment may state the unit ("# units:
/// mm"). Everything else is passed over. Point k is the k-th `v` line: texture seams split nothing.
/// Throws InputError with file and line.
ObjContents readObj(const std::string& path);
}
