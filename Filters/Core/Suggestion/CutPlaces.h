// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

#include <vector>

namespace flattening
{
/// Vertices inside a surface where darts may end.
struct CutPlaces
{
  Indices tips;  ///< spread over all of the inside
  Indices sites; ///< those of the tips around which most curvature lies, where it is positive
};

/// \param barred per vertex, whether it lies on a key curve, which no cut may cross
CutPlaces cutPlaces(const TriangleMesh& mesh, const std::vector<char>& barred);
}
