// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/PathGraph.h"
#include "Paths/StripUnfolding.h"

#include <limits>
#include <vector>

namespace flattening
{
/// Which arcs of a graph a search uses.
enum class PathArcs
{
  All,
  Edges,
};

/// The shortest paths of a graph from a point of its surface to others, one after another (A*: P.
/// E. Hart, N. J. Nilsson and B. Raphael, 1968): what straight paths start from.
///
/// Distances found for earlier targets are kept, so that a target near one of them takes next to no
/// time. They change no path: of several that are equally short it is always the same.
class PathSearch
{
public:
  /// The graph must outlive the search. \pre The source lies on the graph's mesh.
  PathSearch(const PathGraph& graph, const SurfacePoint& source, PathArcs arcs = PathArcs::All);

  const PathGraph& graph() const { return this->Graph; }
  const SurfacePoint& source() const { return this->Source; }
  PathArcs arcs() const { return this->Used; }
  /// The shortest path to a target; no vertices where there is none. \pre The target
  /// lies on the graph's mesh.
  GeodesicPath geodesicTo(const SurfacePoint& target);

private:
  /// What is known of a vertex, in one place of memory.
  struct State
  {
    double distance = std::numeric_limits<double>::infinity();
    Index before = none;  ///< the vertex it is reached from; none from the source itself
    bool settled = false; ///< its arcs were followed since it was reached by a shorter path
  };
  struct Entry
  {
    double bound = 0.0; ///< of the whole path
    Index vertex = none;
    bool operator<(const Entry& other) const { return this->bound > other.bound; }
  };

  /// The corner of the triangles around a target by which the shortest path comes; none where there
  /// is none.
  Index lastVertex(const SurfacePoint& target);
  void followArcs(Index vertex, const Point3& target);
  Index crossedBetween(Index from, Index to) const;

  const PathGraph& Graph;
  SurfacePoint Source;
  PathArcs Used;
  std::vector<State> States;
  std::vector<Entry> Open; ///< a heap
};
}
