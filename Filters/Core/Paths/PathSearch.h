// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/PathCourse.h"
#include "Paths/PathGraph.h"

#include <limits>

namespace flattening
{
/// Which ways of a graph a search takes.
enum class PathWays
{
  All,
  Edges,
};

/// The shortest ways of a graph from a point of its surface (E. W. Dijkstra, 1959): where straight
/// paths start from.
class PathSearch
{
public:
  /// Looks for one target only (A*), or for every vertex within reach of the source. The graph must
  /// outlive the search. \pre The source lies on the graph's mesh.
  PathSearch(const PathGraph& graph, const SurfacePoint& source, const SurfacePoint& target,
    PathWays ways = PathWays::All);
  PathSearch(const PathGraph& graph, const SurfacePoint& source,
    double reach = std::numeric_limits<double>::infinity());

  const PathGraph& graph() const { return this->Graph; }
  const SurfacePoint& source() const { return this->Source; }
  /// Length of the shortest way to a vertex; infinite where none was found.
  double distance(Index vertex) const { return this->Found[vertex].distance; }
  /// The shortest way to a target as a course; no knots where none was found.
  PathCourse courseTo(const SurfacePoint& target) const;

private:
  /// What is known of a vertex, in one place of memory: most of a search is waiting for it.
  struct State
  {
    double distance = std::numeric_limits<double>::infinity();
    const PathGraph::Way* way = nullptr; ///< that reaches it; null from the source itself
    Index before = none;                 ///< whence
    bool settled = false;
  };
  void run(const SurfacePoint* target, double reach, PathWays ways);

  const PathGraph& Graph;
  SurfacePoint Source;
  std::vector<State> Found; ///< by vertex
};
}
