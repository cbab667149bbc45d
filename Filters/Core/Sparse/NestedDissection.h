// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <cmath>
#include <vector>

namespace flattening
{
/// The fewest vertices of a graph without which no way leads from its left to its right: as many as
/// there are ways at most of which no two share a vertex (K. Menger, "Zur allgemeinen
/// Kurventheorie", 1927). The ways are found as a flow through vertices of capacity 1 (L. R. Ford,
/// D. R. Fulkerson, "Maximal flow through a network", 1956).
class VertexSeparator
{
public:
  enum class Side : char
  {
    Outside, ///< of the part that is looked at
    Left,
    Between, ///< may separate
    Right,
  };

  /// \param begin, neighbours of each vertex, in flat arrays that outlive this; a neighbour may come
  /// twice.
  VertexSeparator(const Indices& begin, const Indices& neighbours);

  Side side(Index v) const { return this->Sides[v]; }
  void setSide(Index v, Side side) { this->Sides[v] = side; }

  /// Finds them among the vertices between the sides: those stay there, the others go to the left
  /// or the right. No vertex of the left may have a neighbour on the right.
  /// \param between those whose side is that, from the left to the right: ways are looked for in the
  /// direction of the last first.
  /// \param most how many there may be. False where it takes more; sides are open then.
  bool separate(const Indices& between, Index most);

private:
  // A way enters a vertex and leaves it: states 2 k and 2 k + 1 of the k-th vertex between.
  void build(const Indices& between);
  Index following(Index state, Index a) const;
  bool addWay(Index start);
  void takeWay();

  const Indices& Begin;
  const Indices& Neighbours;
  std::vector<Side> Sides;
  Indices Place; ///< of each vertex among those between
  // By place.
  Indices FirstBeside; ///< into Beside: of the neighbours between
  Indices Beside;      ///< from the last to the first
  std::vector<char> AtRight;
  Indices AtLeft;   ///< places with a neighbour on the left
  Indices Previous; ///< on the way through a vertex, or where that begins
  Indices Next;     ///< the same, or where it ends; none: there is no way
  // By state.
  std::vector<char> Tried;
  Indices Arc; ///< the next one to be tried
  Indices Way;
};

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

/// Number of neighbors from which a vertex among `count` is a hub: to eliminate it before them
/// would couple them all. Minimum degree orders treat dense rows in the same way (P. R. Amestoy, T.
/// A. Davis, I. S. Duff, "Algorithm 837: AMD", 2004).
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
