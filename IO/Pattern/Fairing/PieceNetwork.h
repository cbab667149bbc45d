// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairSolver.h"
#include "Fairing/OutlineMirror.h"

#include <cstddef>
#include <map>
#include <vector>

namespace flattening::pattern
{
/// The planned chains of one piece as a network to solve. Its nodes are corners, and points that
/// chains share.
class PieceNetwork
{
public:
  /// \param work see FairNetwork; it stays the caller's
  PieceNetwork(const DrawingSource& all, const BorderChains& chains,
    const std::vector<PlannedChain>& plan, std::size_t piece, const OutlineMirror& mirror,
    double& work);

  const FairNetwork& network() const { return this->Network; }
  /// The number of a stretch in it, by its chain and first point; it is no raw one.
  std::size_t indexOf(std::size_t chain, std::size_t firstPoint) const;
  /// Writes the solution to the chains of this piece: spans along them, deviations of their points.
  void take(const FairCurves& curves, std::vector<std::vector<FairSpan>>& spans,
    std::vector<std::vector<double>>& deviation) const;

private:
  /// Where a stretch of the network comes from.
  struct Origin
  {
    std::size_t chain = 0;
    std::size_t firstPoint = 0; ///< of the chain
    double start = 0.0;         ///< along it
  };

  std::size_t nodeAt(Index point);
  void add(std::size_t c, const PlannedStretch& planned);
  void addEdges(std::size_t c, const PlannedStretch& planned);
  void addMirror(const OutlineMirror& mirror);

  const DrawingSource& All;
  const BorderChains& Chains;
  const std::vector<PlannedChain>& Plan;
  FairNetwork Network;
  std::vector<Origin> Origins;
  std::map<Index, std::size_t> Nodes;
};
}
