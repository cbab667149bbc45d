// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairSolver.h"
#include "Fairing/OutlineMirror.h"

#include <cstddef>
#include <map>
#include <vector>

namespace flattening
{
namespace pattern
{
/// Which node is the image of which, as far as that follows.
class NodeImages
{
public:
  explicit NodeImages(const FairNetwork& network)
    : Images(network.nodes.size(), unknown)
    , Hooked(network.nodes.size(), false)
  {
    for (const FairStretch& stretch : network.stretches)
    {
      for (const FairHook& hook : stretch.hooks)
      {
        this->Hooked[hook.node] = true;
      }
    }
  }

  /// Whether one may be the image of the other: what hangs on a curve only if it does so there.
  bool mayBe(std::size_t one, std::size_t other) const
  {
    return this->Images[one] == unknown && this->Images[other] == unknown
      ? !this->Hooked[one] && !this->Hooked[other]
      : this->Images[one] == other && this->Images[other] == one;
  }

  bool areUnknown(std::size_t one, std::size_t other) const
  {
    return this->Images[one] == unknown && this->Images[other] == unknown;
  }

  void join(std::size_t one, std::size_t other)
  {
    this->Images[one] = other;
    this->Images[other] = one;
  }

private:
  static constexpr std::size_t unknown = static_cast<std::size_t>(-1);

  std::vector<std::size_t> Images;
  std::vector<bool> Hooked;
};

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
  /// Stretches that were to be mirror images of each other and cannot be, since what hangs on other
  /// curves does not do so at images.
  const std::vector<MirroredStretches>& unlike() const { return this->Unlike; }
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
  /// \return false: they cannot be images of each other, or not yet
  bool addImages(const MirroredStretches& pair, bool outline, NodeImages& images);

  const DrawingSource& All;
  const BorderChains& Chains;
  const std::vector<PlannedChain>& Plan;
  FairNetwork Network;
  std::vector<Origin> Origins;
  std::vector<MirroredStretches> Unlike;
  std::map<Index, std::size_t> Nodes;
};
}
}
