// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/PathCourse.h"
#include "Paths/PathGraph.h"

#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace flattening
{
/// Which ways of a graph a search takes.
enum class PathWays
{
  All,
  Edges,
};

/// The shortest ways of a graph from a point of its surface to others, one after another (A*: P. E.
/// Hart, N. J. Nilsson and B. Raphael, 1968): where straight paths start from.
///
/// What was found on the way to earlier targets is kept, so that a target near one of them takes
/// next to no time. It changes no way: of those that are equally short it is always the same.
class PathSearch
{
public:
  /// The graph must outlive the search. \pre The source lies on the graph's mesh.
  PathSearch(const PathGraph& graph, const SurfacePoint& source, PathWays ways = PathWays::All);

  const PathGraph& graph() const { return this->Graph; }
  const SurfacePoint& source() const { return this->Source; }
  PathWays ways() const { return this->Taken; }
  /// The shortest way to a target as a course; no knots where there is none. \pre The target lies
  /// on the graph's mesh.
  PathCourse courseTo(const SurfacePoint& target);

private:
  /// What is known of a node, in one place of memory.
  struct State
  {
    WayLength distance = std::numeric_limits<WayLength>::max();
    Index before = none;  ///< whence; none from the source itself
    bool settled = false; ///< all ways from it were looked at since it was reached by a shorter one
  };
  /// States are made as a search comes to them: most searches stay near their source.
  using Page = std::array<State, 512>;
  struct Entry
  {
    WayLength bound = 0; ///< of the whole way
    Index node = none;
    bool operator<(const Entry& other) const { return this->bound > other.bound; }
  };

  struct Mark
  {
    std::size_t landmark = 0;
    WayLength toTarget = 0;
  };

  State& state(Index node)
  {
    const std::size_t size = std::tuple_size<Page>::value;
    std::unique_ptr<Page>& page = this->Pages[node / size];
    if (!page)
    {
      page = std::make_unique<Page>();
    }
    return (*page)[node % size];
  }
  WayLength ahead(Index node, const Point3& target) const;
  void chooseMarks(const SurfacePoint& target, const Indices& goals);
  void aimAt(const SurfacePoint& target, const Indices& goals);
  /// The corner of the triangles around a target by which the shortest way comes; none where there
  /// is none.
  Index lastNode(const SurfacePoint& target);
  void lookFrom(Index node, const Point3& target);
  Indices chainTo(Index node);
  Index crossedBetween(Index from, Index to) const;

  const PathGraph& Graph;
  SurfacePoint Source;
  PathWays Taken;
  std::vector<std::unique_ptr<Page>> Pages;
  std::vector<Entry> Open; ///< a heap
  /// Landmarks by which a way to the target seems longest, how far they are from it, and how many
  /// there are.
  std::array<Mark, 8> Marks{};
  std::size_t MarkCount = 0;
};
}
