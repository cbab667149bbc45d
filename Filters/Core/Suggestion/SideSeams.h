// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CurveSuggestions.h"
#include "Suggestion/SymmetryPlane.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Seams that part a surface with openings into a front and a back, as those of garments: from
/// opening to opening all the way round, such as side seams from hem to sleeve and shoulder seams
/// from sleeve to neck of a shirt, or side seams and inseam of trousers.
///
/// The front lies across the axis along which the surface extends least, in the mirror plane where
/// there is one. Openings follow each other around that axis, and each is joined to the next by
/// the shortest way, where edges that face front or back count for more. With a plane, seams of one
/// side come with their images.
///
/// \return empty where the surface is no tube, with two openings or more that do not turn as holes in
/// a flat piece, where it has handles, or where no such ways are found
std::vector<SuggestedCurve> sideSeams(
  const TriangleMesh& mesh, const std::optional<SurfaceMirror>& mirror);
}
