// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/Dissection.h"

namespace flattening
{
/// An order of elimination with little fill-in for matrices with the pattern of a triangle mesh:
/// nested dissection (A. George, "Nested dissection of a regular finite element mesh", 1973). A
/// plane across the longest extent of a part halves it; the vertices next to the plane come last.
/// Hubs of a part come after all others of it, so that fans of any width cost no dense block. The
/// ranges are these separators and the parts that are not divided any more.
/// \param cliques vertices that are coupled with each other, such as the corners of each triangle;
/// a vertex may come twice. \param positions per vertex.
Dissection dissect(
  const Triangles& cliques, const Points3& positions, Separators separators = Separators::Quick);

/// The same by the pattern alone, so that the order stays when vertices move: parts are halved by
/// their level structure (A. George, J. W. H. Liu, "Computer Solution of Large Sparse Positive
/// Definite Systems", 1981, chapter 8), where the vertices at the middle distance from an end of
/// the part, counted in edges, come last. A little more fill-in in small meshes, much in large
/// ones.
/// \param count of the vertices.
Dissection dissect(const Triangles& cliques, Index count);
}
