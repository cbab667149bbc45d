// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <map>

namespace flattening
{
/// A constrained Delaunay triangulation inside one triangle of a surface.
///
/// Side points come first, then inner points, then segments. Points nearer to each other than the
/// snap distance become one vertex, a segment that passes a vertex within the snap distance goes
/// through it, and crossing segments share a new vertex. Vertices 0, 1, 2 are the corners.
class ConstrainedDelaunay
{
public:
  using Weights = std::array<double, 3>;

  ConstrainedDelaunay(const Point3& a, const Point3& b, const Point3& c, double snap);

  /// A point on the side from corner `side` to the next; those of a side in ascending order.
  Index addSidePoint(int side, double fraction);
  /// The vertex at an inner point: a new one, or one within the snap distance.
  Index addPoint(const Weights& weights);
  /// False where rounding prevents it; a larger snap distance helps.
  bool addSegment(Index from, Index to);
  /// The vertices along a segment that was added, with those added to it later.
  Indices chain(Index from, Index to) const;
  /// Swaps the free edges that are not Delaunay.
  void refine();

  Index vertexCount() const { return static_cast<Index>(this->Positions.size()); }
  /// Weights of the three corners.
  const Weights& weights(Index vertex) const { return this->VertexWeights[vertex]; }
  const Triangles& triangles() const { return this->Cells; }

private:
  struct Side
  {
    Index vertex; ///< where it starts
    Index twin;
    bool fixed;
  };

  Index from(Index h) const { return this->Cells[h / 3][h % 3]; }
  Index to(Index h) const { return this->from(next(h)); }
  Index apex(Index h) const { return this->from(previous(h)); }
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index counterClockwise(Index h) const { return this->Twins[previous(h)]; }
  Index find(Index fromVertex, Index toVertex) const;
  Indices outgoing(Index vertex) const;
  Side side(Index h) const { return { this->from(h), this->Twins[h], this->Fixed[h] != 0 }; }
  double orient(Index a, Index b, Index c) const;
  bool surelyPositive(Index a, Index b, Index c) const;

  Index addVertex(const Weights& weights);
  Index addTriangle();
  void setTriangle(Index t, const Side& a, const Side& b, const Side& c);
  void fix(Index h);
  void splitTriangle(Index t, Index vertex);
  void splitEdge(Index h, Index vertex);
  bool canFlip(Index h) const;
  void flip(Index h);
  void makeDelaunay(Indices stack);
  Index locate(const Point2& point) const;
  Point2 position(const Weights& weights) const;

  bool passes(Index start, Index end, Index vertex) const;
  Index neighbourOnTheWay(Index start, Index end) const;
  Index firstCrossed(Index start, Index end) const;
  Index crossEdge(Index h, Index start, Index end);
  Index advance(Index start, Index end);
  bool recover(Index start, Index end, const std::vector<std::array<Index, 2>>& crossed);

  double Snap;
  Points2 Corners;
  Triangle LastOnSide{ 0, 1, 2 };
  Points2 Positions;
  std::vector<Weights> VertexWeights;
  Triangles Cells;
  Indices Twins;
  std::vector<char> Fixed;
  Indices Outgoing; ///< on the boundary the half-edge without a twin
  std::map<std::array<Index, 2>, Indices> Segments;
  std::map<std::array<Index, 2>, Index> Splits; ///< fixed edge -> vertex put on it
};
}
