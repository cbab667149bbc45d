// SPDX-License-Identifier: BSD-3-Clause
#include "CutClosure.h"

#include "BoundaryOverlap.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
namespace
{
constexpr std::size_t mostOverlaps = 1000;

Point2 turnedLeft(const Point2& v)
{
  return { -v.y(), v.x() };
}

class Closing
{
public:
  Closing(const Piece& piece, const CutSurface& cut, Points2 positions)
    : Subject(piece)
    , Cuts(findCutBanks(piece, cut))
  {
    this->Result.positions = std::move(positions);
    this->Result.joined.resize(piece.mesh.vertexCount());
    std::iota(this->Result.joined.begin(), this->Result.joined.end(), 0);
  }

  CutClosure run(const JoinedFlattening& flatten)
  {
    while (!this->Cuts.empty())
    {
      const std::vector<char> crossing = this->crossingVertices();
      if (std::find(crossing.begin(), crossing.end(), 1) == crossing.end())
      {
        this->Result.closed = true;
        break;
      }
      if (!this->joinCrossed(crossing) && !this->joinCrossing(crossing))
      {
        break;
      }
      Points2 positions = flatten(this->Result.joined);
      if (positions.empty())
      {
        break;
      }
      this->Result.positions = std::move(positions);
    }
    this->findClosedEdges();
    return std::move(this->Result);
  }

private:
  std::vector<char> crossingVertices() const
  {
    const TriangleMesh& mesh = this->Subject.mesh;
    std::vector<char> crossing(mesh.vertexCount(), 0);
    for (const auto& pair : findBoundaryOverlaps(mesh, this->Result.positions, mostOverlaps))
    {
      for (Index h : pair)
      {
        crossing[mesh.from(h)] = crossing[mesh.to(h)] = 1;
      }
    }
    return crossing;
  }

  /// How far the first bank is from the second, across both: negative where they have crossed.
  double gap(const CutBanks& cut, std::size_t k) const
  {
    const Points2& at = this->Result.positions;
    const std::size_t outer = std::min(k + 1, cut.pairs.size() - 1);
    Point2 across = Point2::Zero();
    for (int bank : { 0, 1 })
    {
      const Index inner = k == 0 ? cut.tip : cut.pairs[k - 1][bank];
      across += turnedLeft((at[inner] - at[cut.pairs[outer][bank]]).normalized());
    }
    return across.dot(at[cut.pairs[k][0]] - at[cut.pairs[k][1]]);
  }

  /// In cuts that take part in a crossing, the pairs that lie on the wrong side of each other.
  bool joinCrossed(const std::vector<char>& crossing)
  {
    std::vector<std::array<Index, 2>> crossed;
    for (const CutBanks& cut : this->Cuts)
    {
      const bool takesPart = std::any_of(cut.pairs.begin(), cut.pairs.end(),
        [&](const auto& pair) { return crossing[pair[0]] || crossing[pair[1]]; });
      for (std::size_t k = 0; takesPart && k < cut.pairs.size(); ++k)
      {
        if (this->gap(cut, k) < 0.0)
        {
          crossed.push_back(cut.pairs[k]);
        }
      }
    }
    return this->join(crossed);
  }

  /// The pairs at the ends of edges that cross although no pair is on the wrong side.
  bool joinCrossing(const std::vector<char>& crossing)
  {
    std::vector<std::array<Index, 2>> ends;
    for (const CutBanks& cut : this->Cuts)
    {
      std::copy_if(cut.pairs.begin(), cut.pairs.end(), std::back_inserter(ends),
        [&](const auto& pair) { return crossing[pair[0]] || crossing[pair[1]]; });
    }
    return this->join(ends);
  }

  /// \return whether one of the pairs was not joined yet.
  bool join(const std::vector<std::array<Index, 2>>& pairs)
  {
    Indices& joined = this->Result.joined;
    bool grown = false;
    for (const auto& pair : pairs)
    {
      const Index from = std::max(joined[pair[0]], joined[pair[1]]);
      const Index to = std::min(joined[pair[0]], joined[pair[1]]);
      if (from != to)
      {
        std::replace(joined.begin(), joined.end(), from, to);
        grown = true;
      }
    }
    return grown;
  }

  void findClosedEdges()
  {
    const TriangleMesh& mesh = this->Subject.mesh;
    const Indices& joined = this->Result.joined;
    for (const CutBanks& cut : this->Cuts)
    {
      std::array<Index, 2> inner{ cut.tip, cut.tip };
      for (const auto& pair : cut.pairs)
      {
        if (joined[inner[0]] == joined[inner[1]] && joined[pair[0]] == joined[pair[1]])
        {
          this->Result.edges.push_back(mesh.find(pair[0], inner[0]));
          this->Result.edges.push_back(mesh.find(inner[1], pair[1]));
        }
        inner = pair;
      }
    }
    // A cut with two tips is found from each.
    std::sort(this->Result.edges.begin(), this->Result.edges.end());
    this->Result.edges.erase(
      std::unique(this->Result.edges.begin(), this->Result.edges.end()), this->Result.edges.end());
  }

  const Piece& Subject;
  std::vector<CutBanks> Cuts;
  CutClosure Result;
};
}

std::vector<CutBanks> findCutBanks(const Piece& piece, const CutSurface& cut)
{
  std::vector<CutBanks> cuts;
  for (const Indices& loop : piece.mesh.boundaryLoops())
  {
    const std::size_t count = loop.size();
    const auto vertex = [&](std::size_t k) { return piece.mesh.from(loop[k % count]); };
    for (std::size_t tip = 0; tip < count; ++tip)
    {
      CutBanks banks;
      banks.tip = vertex(tip);
      for (std::size_t k = 1; 2 * k < count; ++k)
      {
        const std::array<Index, 2> pair{ vertex(tip + count - k), vertex(tip + k) };
        if (cut.originalVertex[piece.vertices[pair[0]]] !=
          cut.originalVertex[piece.vertices[pair[1]]])
        {
          break;
        }
        banks.pairs.push_back(pair);
      }
      if (!banks.pairs.empty())
      {
        cuts.push_back(std::move(banks));
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

CutClosure closeCrossingCuts(
  const Piece& piece, const CutSurface& cut, Points2 positions, const JoinedFlattening& flatten)
{
  return Closing(piece, cut, std::move(positions)).run(flatten);
}
}
