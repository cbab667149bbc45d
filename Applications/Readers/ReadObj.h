// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace wirewarp
{
/// What an OBJ file holds, over one list of points.
struct ObjContents
{
  vtkSmartPointer<vtkPolyData> surface; ///< its faces
  vtkSmartPointer<vtkPolyData> curves;  ///< its line elements; null where there is none
  std::string unit;                     ///< that a comment states, as in Units.h; empty: none
};

/// Reads Wavefront OBJ with coordinates in double precision.
///
/// `v`, `f` (polygons; `v`, `v/vt`, `v//vn`, `v/vt/vn`; negative ids count from the end) and `l`
/// are read, and of `g` and `o` the names, which give type and name to the lines below them: "dart
/// left", see CurveList.h; a comment may state the unit ("# units: mm"). Everything else is passed
/// over. Point k is the k-th `v` line: texture
/// seams split nothing. Throws InputError with file and line.
ObjContents readObj(const std::string& path);
}
