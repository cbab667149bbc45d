// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

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
}
