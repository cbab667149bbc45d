// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Shortest ways along mesh edges from the nearest of some vertices. They do not run through barred
/// vertices, though they may end there.
class EdgePaths
{
public:
  enum class Through
  {
    Inside,  ///< boundary vertices are barred
    Boundary ///< as well
  };

  /// \param barred per vertex; empty: none is \param lengths per half-edge; empty: those in space
  explicit EdgePaths(const TriangleMesh& mesh, const Indices& starts,
    const std::vector<char>& barred = {}, Through through = Through::Inside,
    const std::vector<double>& lengths = {});

  bool reaches(Index vertex) const { return this->Before[vertex] != none; }
  /// The vertex before on the way; the vertex itself at a start.
  Index before(Index vertex) const { return this->Before[vertex]; }
  double distance(Index vertex) const { return this->Distance[vertex]; }
  /// From a start to the vertex. \pre reaches(vertex)
  Indices path(Index vertex) const;

private:
  std::vector<double> Distance;
  Indices Before; ///< a start of itself; none: not reached
};

/// Paths along edges that join boundary loops to the first one: each goes from a loop that is
/// joined already to the nearest one that is not, as long as there is one that can be reached.
/// \param barred per vertex, whether no path may meet it; empty: none is
std::vector<Indices> joiningPaths(
  const TriangleMesh& mesh, std::vector<Indices> loops, const std::vector<char>& barred = {});
}
