// SPDX-License-Identifier: BSD-3-Clause
#include "Cut/CutClosure.h"

#include "Quality/BoundaryOverlap.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace flattening
{
std::vector<CutSides> findCutSides(const Piece& piece, const CutSurface& cut)
{
  std::vector<CutSides> cuts;
  for (const Indices& loop : piece.mesh.boundaryLoops())
  {
    const std::size_t count = loop.size();
    const auto vertex = [&](std::size_t k) { return piece.mesh.from(loop[k % count]); };
    for (std::size_t tip = 0; tip < count; ++tip)
    {
      CutSides sides;
      sides.tip = vertex(tip);
      for (std::size_t k = 1; 2 * k < count; ++k)
      {
        const std::array<Index, 2> pair{ vertex(tip + count - k), vertex(tip + k) };
        if (cut.originalVertex[piece.vertices[pair[0]]] !=
          cut.originalVertex[piece.vertices[pair[1]]])
        {
          break;
        }
        sides.pairs.push_back(pair);
      }
      if (!sides.pairs.empty())
      {
        cuts.push_back(std::move(sides));
      }
    }
  }
  return cuts;
}

JoinedPiece joinVertices(const Piece& piece, const Indices& joined)
{
  JoinedPiece result;
  Points3 points;
  for (std::size_t v = 0; v < joined.size(); ++v)
  {
    if (joined[v] == static_cast<Index>(v))
    {
      result.place.push_back(static_cast<Index>(points.size()));
      points.push_back(piece.mesh.point(joined[v]));
      result.piece.vertices.push_back(piece.vertices[v]);
    }
    else
    {
      result.place.push_back(none);
    }
  }
  for (std::size_t v = 0; v < joined.size(); ++v)
  {
    result.place[v] = result.place[joined[v]];
  }
  Triangles triangles = piece.mesh.triangles();
  for (Triangle& triangle : triangles)
  {
    for (Index& v : triangle)
    {
      v = result.place[v];
    }
  }
  result.piece.mesh = TriangleMesh(std::move(points), std::move(triangles));
  result.piece.triangles = piece.triangles;
  result.piece.curveOfHalfedge = piece.curveOfHalfedge;
  return result;
}

namespace
{
Point2 turnedLeft(const Point2& v)
{
  return { -v.y(), v.x() };
}

/// Which vertices of a piece closeCuts() has joined.
class JoinedCuts
{
public:
  JoinedCuts(const Piece& piece, const CutSurface& cut)
    : Subject(piece)
    , Cut(cut)
    , Cuts(findCutSides(piece, cut))
    , Joined(piece.mesh.vertexCount())
  {
    std::iota(this->Joined.begin(), this->Joined.end(), 0);
    this->NextJoined = this->Joined;
  }

  /// Joins more of the pairs. \param positions as flattened last; null where that failed
  /// \return false where there is nothing more to join, or to close
  bool advance(const Points2* positions)
  {
    const auto all = [](const CutSides&, std::size_t) { return true; };
    if (!positions)
    {
      // A piece that cannot be flattened with its cuts closed in part may be with whole ones.
      return this->join(this->pairsWhere(all));
    }
    this->Crossing = this->crossingVertices(*positions);
    this->Closed =
      std::find(this->Crossing.begin(), this->Crossing.end(), 1) == this->Crossing.end();
    // The pairs that lie on the wrong side of each other.
    const auto crossed = [&](const CutSides& cut, std::size_t k) {
      return this->gap(*positions, cut, k) < 0.0;
    };
    // Those at the ends of edges that cross although no pair is on the wrong side.
    const auto crossing = [&](const CutSides& cut, std::size_t k) {
      return this->Crossing[cut.pairs[k][0]] || this->Crossing[cut.pairs[k][1]];
    };
    return !this->Closed &&
      (this->join(this->pairsWhere(crossed)) || this->join(this->pairsWhere(crossing)) ||
        this->join(this->pairsWhere(all)));
  }

  const Indices& joined() const { return this->Joined; }

  /// Half-edges that lie on another one; none where some still cross.
  Indices closedEdges() const
  {
    Indices edges;
    if (!this->Closed)
    {
      return edges;
    }
    const TriangleMesh& mesh = this->Subject.mesh;
    const JoinedPiece now = joinVertices(this->Subject, this->Joined);
    for (Index h = 0; h < mesh.halfedgeCount(); ++h)
    {
      if (mesh.twin(h) == none && now.piece.mesh.twin(h) != none)
      {
        edges.push_back(h);
      }
    }
    return edges;
  }

private:
  using Pairs = std::vector<std::array<Index, 2>>;

  std::vector<char> crossingVertices(const Points2& positions) const
  {
    const TriangleMesh& mesh = this->Subject.mesh;
    std::vector<char> crossing(mesh.vertexCount(), 0);
    for (const auto& pair : findBoundaryOverlaps(mesh, positions, mostListedOverlaps))
    {
      for (Index h : pair)
      {
        crossing[mesh.from(h)] = crossing[mesh.to(h)] = 1;
        crossing[this->Joined[mesh.from(h)]] = crossing[this->Joined[mesh.to(h)]] = 1;
      }
    }
    return crossing;
  }

  /// How far the first side is from the second, across both: negative where they have crossed.
  double gap(const Points2& positions, const CutSides& cut, std::size_t k) const
  {
    const Points2& at = positions;
    const std::size_t outer = std::min(k + 1, cut.pairs.size() - 1);
    Point2 across = Point2::Zero();
    for (int side : { 0, 1 })
    {
      const Index inner = k == 0 ? cut.tip : cut.pairs[k - 1][side];
      across += turnedLeft((at[inner] - at[cut.pairs[outer][side]]).normalized());
    }
    return across.dot(at[cut.pairs[k][0]] - at[cut.pairs[k][1]]);
  }

  bool takesPart(const CutSides& cut) const
  {
    return this->Crossing[cut.tip] ||
      std::any_of(cut.pairs.begin(), cut.pairs.end(),
        [&](const auto& pair) { return this->Crossing[pair[0]] || this->Crossing[pair[1]]; });
  }

  /// Of cuts that take part in a crossing the pairs that a test of a cut and a place in its list
  /// holds of.
  template <typename Test>
  Pairs pairsWhere(const Test& test) const
  {
    Pairs found;
    for (const CutSides& cut : this->Cuts)
    {
      const std::size_t count = this->takesPart(cut) ? cut.pairs.size() : 0;
      for (std::size_t k = 0; k < count; ++k)
      {
        if (test(cut, k))
        {
          found.push_back(cut.pairs[k]);
        }
      }
    }
    return found;
  }

  bool joinPair(const std::array<Index, 2>& pair)
  {
    Indices& joined = this->Joined;
    const Index from = std::max(joined[pair[0]], joined[pair[1]]);
    const Index to = std::min(joined[pair[0]], joined[pair[1]]);
    if (from == to)
    {
      return false;
    }
    for (Index v = from; joined[v] != to; v = this->NextJoined[v])
    {
      joined[v] = to;
    }
    std::swap(this->NextJoined[from], this->NextJoined[to]);
    return true;
  }

  /// \return whether one of the pairs was not joined yet.
  bool join(const Pairs& pairs)
  {
    bool grown = false;
    for (const auto& pair : pairs)
    {
      grown = this->joinPair(pair) || grown;
    }
    if (grown)
    {
      while (this->joinNextToLonePairs())
      {
      }
      this->findCutsAnew();
    }
    return grown;
  }

  /// A pair joined by itself holds two fans of triangles together at one vertex: the pair next to
  /// it towards the tip is joined as well.
  bool joinNextToLonePairs()
  {
    Indices& joined = this->Joined;
    const JoinedPiece now = joinVertices(this->Subject, joined);
    const TriangleMesh& mesh = now.piece.mesh;
    Indices fans(mesh.vertexCount(), 0);
    for (Index h = 0; h < mesh.halfedgeCount(); ++h)
    {
      fans[mesh.from(h)] += mesh.twin(h) == none ? 1 : 0;
    }
    bool grown = false;
    for (const CutSides& cut : this->Cuts)
    {
      for (std::size_t k = 1; k < cut.pairs.size(); ++k)
      {
        const auto [a, b] = cut.pairs[k];
        if (joined[a] == joined[b] && fans[now.place[a]] > 1)
        {
          grown = this->joinPair(cut.pairs[k - 1]) || grown;
        }
      }
    }
    return grown;
  }

  /// Where cuts meet, one that is closed up to there makes a tip of another.
  void findCutsAnew()
  {
    const JoinedPiece now = joinVertices(this->Subject, this->Joined);
    Indices before(now.piece.mesh.vertexCount());
    for (std::size_t v = 0; v < now.place.size(); ++v)
    {
      before[now.place[v]] = this->Joined[v];
    }
    std::vector<CutSides> cuts = findCutSides(now.piece, this->Cut);
    for (CutSides& cut : cuts)
    {
      cut.tip = before[cut.tip];
      for (auto& pair : cut.pairs)
      {
        pair = { before[pair[0]], before[pair[1]] };
      }
    }
    this->Cuts = std::move(cuts);
  }

  const Piece& Subject;
  const CutSurface& Cut;
  std::vector<CutSides> Cuts; ///< with what is joined left out
  Indices Joined;
  Indices NextJoined;         ///< per vertex the next one of those joined with it, in a ring
  std::vector<char> Crossing; ///< vertices on boundary edges that cross
  bool Closed = false;        ///< none cross any more
};
}

Indices closeCuts(
  const Piece& piece, const CutSurface& cut, const Points2& positions, const FlattenJoined& flatten)
{
  JoinedCuts cuts(piece, cut);
  std::optional<Points2> flat = positions;
  bool tried = false;
  while (cuts.advance(flat ? &*flat : nullptr))
  {
    flat = flatten(cuts.joined());
    tried = true;
  }
  return tried ? cuts.closedEdges() : Indices();
}
}
