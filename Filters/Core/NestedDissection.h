// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Types.h"

namespace flattening
{
/// An order of elimination with little fill-in for matrices with the pattern of a triangle mesh:
/// halves the vertices by a plane across their longest extent again and again, and puts those that
/// separate the halves last (A. George, "Nested dissection of a regular finite element mesh",
/// 1973).
/// \param cliques vertices that are coupled with each other, such as the corners of each triangle.
Indices dissect(const Triangles& cliques, const Points3& positions);
}
