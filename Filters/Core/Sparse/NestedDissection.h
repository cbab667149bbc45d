// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <cmath>
#include <vector>

namespace flattening
{
/// An order of elimination, and the ranges of it that hang together: the vertices of range k are
/// order[end[k - 1]] .. order[end[k] - 1].
struct Dissection
{
  Indices order; ///< which vertex is eliminated first, second, ...
  Indices end;

  /// Ends a range before a place of the order, unless it is empty.
  void endRange(Index place)
  {
    if (place > (this->end.empty() ? 0 : this->end.back()))
    {
      this->end.push_back(place);
    }
  }

  /// The same of other things than vertices: append(k, order) puts those of the k-th in order,
  /// which stay in its range.
  template <typename Append>
  Dissection replaced(const Append& append) const
  {
    Dissection result;
    Index k = 0;
    for (Index last : this->end)
    {
      for (; k < last; ++k)
      {
        append(k, result.order);
      }
      result.endRange(static_cast<Index>(result.order.size()));
    }
    return result;
  }

  /// The same of unknowns, some for each vertex v: firstOf(v) and those that follow, or none.
  template <typename FirstOf>
  Dissection ofUnknowns(Index count, const FirstOf& firstOf) const
  {
    return this->replaced([&](Index k, Indices& unknowns) {
      const Index first = firstOf(this->order[k]);
      for (Index i = 0; first != none && i < count; ++i)
      {
        unknowns.push_back(first + i);
      }
    });
  }
};

/// Number of neighbors from which a vertex among `count` is a hub: to eliminate it before them
/// would couple them all. Minimum degree orders treat dense rows in the same way (P. R. Amestoy, T.
/// A. Davis, I. S. Duff, "Algorithm 837: AMD", 2004).
inline Index hubValence(Index count)
{
  return static_cast<Index>(10.0 * std::sqrt(static_cast<double>(count)));
}

/// An order of elimination with little fill-in for matrices with the pattern of a triangle mesh:
/// nested dissection (A. George, "Nested dissection of a regular finite element mesh", 1973). A
/// plane across the longest extent of a part divides it near its middle, where the fewest vertices
/// are next to the plane; those come last.
/// Hubs of a part come after all others of it, so that fans of any width cost no dense block. The
/// ranges are these separators and the parts that are not divided any more.
/// \param cliques vertices that are coupled with each other, such as the corners of each triangle;
/// a vertex may come twice. \param positions per vertex.
Dissection dissect(const Triangles& cliques, const Points3& positions);

/// The same by the pattern alone, so that the order stays when vertices move: parts are halved by
/// their level structure (A. George, J. W. H. Liu, "Computer Solution of Large Sparse Positive
/// Definite Systems", 1981, chapter 8), where the vertices at the middle distance from an end of
/// the part, counted in edges, come last. A little more fill-in in small meshes, much in large
/// ones.
/// \param count of the vertices.
Dissection dissect(const Triangles& cliques, Index count);
}
