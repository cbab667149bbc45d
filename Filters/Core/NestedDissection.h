// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Types.h"

namespace flattening
{
/// An order of elimination, and the ranges of it that hang together: the vertices of range k are
/// order[end[k - 1]] .. order[end[k] - 1].
struct Dissection
{
  Indices order; ///< which vertex is eliminated first, second, ...
  Indices end;

  /// Ends a range after what has been put in order.
  void endRange()
  {
    if (!this->order.empty() && (this->end.empty() || this->end.back() < Index(this->order.size())))
    {
      this->end.push_back(Index(this->order.size()));
    }
  }
};

/// An order of elimination with little fill-in for matrices with the pattern of a triangle mesh:
/// halves the vertices by a plane across their longest extent again and again, and puts those that
/// separate the halves last (A. George, "Nested dissection of a regular finite element mesh",
/// 1973). The ranges are the separators and the parts that are not divided any more.
/// \param cliques vertices that are coupled with each other, such as the corners of each triangle.
/// \param positions per vertex.
Dissection dissect(const Triangles& cliques, const Points3& positions);
}
