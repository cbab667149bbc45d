// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <cmath>

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
};

/// From how many neighbours on a vertex among so many is a hub: to eliminate it before them would
/// couple them all. Dense rows of minimum degree orders are told so as well (P. R. Amestoy, T. A.
/// Davis, I. S. Duff, "Algorithm 837: AMD", 2004).
inline Index hubValence(Index count)
{
  return static_cast<Index>(10.0 * std::sqrt(static_cast<double>(count)));
}

/// How separators are found along a plane.
enum class Separators
{
  Quick, ///< what is next to it
  /// The fewest vertices near it: twice the time for a sixth fewer operations, which pays for
  /// matrices that are factored several times.
  Fewest,
};
}
