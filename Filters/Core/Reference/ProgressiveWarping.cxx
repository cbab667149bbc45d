// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ProgressiveWarping.h"

#include "Angles/AngleProblem.h"
#include "Reference/SequentialAngleSolver.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace flattening
{
namespace
{
/// Adds the host vertices of a loop, numbered in the order of the whole network. A vertex is
/// interior where all angles around it are the loop's.
void addHosts(const WireNetwork& whole, Index loop, WireNetwork& single)
{
  const Index begin = whole.loopBegin[loop];
  const Index end = whole.loopBegin[loop + 1];
  single.vertex.assign(end - begin, none);
  Indices hosts;
  for (Index side = begin; side < end; ++side)
  {
    hosts.push_back(whole.hostOfVertex[whole.vertex[side]]);
  }
  sortUnique(hosts);
  for (Index host : hosts)
  {
    const auto id = static_cast<Index>(single.hostVertices.size());
    bool enclosed = whole.interior[host] != 0;
    single.vertexNodeBegin.push_back(static_cast<Index>(single.vertexNodes.size()));
    for (Index n = whole.vertexNodeBegin[host]; n < whole.vertexNodeBegin[host + 1]; ++n)
    {
      const Index node = whole.vertexNodes[n];
      if (whole.loop[node] == loop)
      {
        single.vertexNodes.push_back(node - begin);
        single.vertex[node - begin] = id;
      }
      else
      {
        enclosed = false;
      }
    }
    single.hostVertices.push_back(id);
    single.hostOfVertex.push_back(id);
    single.interior.push_back(enclosed ? 1 : 0);
  }
  single.vertexNodeBegin.push_back(end - begin);
}

/// A loop of a network as a network of its own, whose nodes are in the same order. A wire with the
/// loop on both sides stays one wire.
WireNetwork singleLoop(const WireNetwork& whole, Index loop)
{
  WireNetwork single;
  addHosts(whole, loop, single);
  const Index begin = whole.loopBegin[loop];
  const Index count = whole.loopBegin[loop + 1] - begin;
  for (Index k = 0; k < count; ++k)
  {
    const Index side = begin + k;
    single.previous.push_back(k == 0 ? count - 1 : k - 1);
    single.next.push_back(k + 1 == count ? 0 : k + 1);
    single.loop.push_back(0);
    single.halfedge.push_back(whole.halfedge[side]);
    single.alpha.push_back(whole.alpha[side]);
    const Index twin = whole.twin[side];
    const bool bothSides = twin != none && whole.loop[twin] == loop;
    single.twin.push_back(bothSides ? twin - begin : none);
    if (bothSides && twin < side)
    {
      single.edge.push_back(single.edge[twin - begin]);
      single.edges[single.edge.back()].otherSide = k;
      continue;
    }
    WireEdge edge;
    edge.from = single.vertex[k];
    edge.to = single.vertex[single.next[k]];
    edge.side = k;
    edge.length = whole.length(side);
    single.edge.push_back(single.edgeCount());
    single.edges.push_back(edge);
  }
  single.loopBegin = { 0, count };
  single.patchOfLoop = { whole.patchOfLoop[loop] };
  single.patchCount = 1;
  return single;
}

/// A wire-patch in the heap of Algorithm 2, keyed by its shape-evidence factor (Eq. 10).
struct HeapEntry
{
  double evidence;
  Index loop;

  bool operator<(const HeapEntry& other) const
  {
    return this->evidence != other.evidence ? this->evidence < other.evidence
                                            : this->loop > other.loop;
  }
};

class Warping
{
public:
  Warping(
    const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution)
    : Problem(problem)
    , Net(*problem.network)
    , Options(options)
    , Run(execution)
    , Known(problem.locks.locked)
    , Theta(problem.locks.angle)
    , Done(Net.loopCount(), 0)
    , Failed(Net.loopCount(), 0)
  {
  }

  ProgressiveSolution run()
  {
    std::priority_queue<HeapEntry> heap;
    for (Index loop = 0; loop < this->Net.loopCount(); ++loop)
    {
      if (!this->Net.isHole(loop)) // what a hole is follows from the patches around it
      {
        heap.push({ this->evidence(loop), loop });
      }
    }
    while (!heap.empty())
    {
      const HeapEntry top = heap.top();
      heap.pop();
      if (this->Done[top.loop] || top.evidence != this->evidence(top.loop))
      {
        continue; // an entry from before its neighbours were warped
      }
      if (!this->warp(top.loop))
      {
        return std::move(this->Result);
      }
      for (Index loop : this->updateNeighbours(top.loop))
      {
        heap.push({ this->evidence(loop), loop });
      }
    }
    this->finish();
    return std::move(this->Result);
  }

private:
  double evidence(Index loop) const
  {
    const auto begin = this->Known.begin() + this->Net.loopBegin[loop];
    const auto end = this->Known.begin() + this->Net.loopBegin[loop + 1];
    return static_cast<double>(std::count(begin, end, 1)) / static_cast<double>(end - begin);
  }

  bool warp(Index loop)
  {
    const WireNetwork single = singleLoop(this->Net, loop);
    const Index begin = this->Net.loopBegin[loop];
    NodeLocks locks;
    locks.locked.assign(
      this->Known.begin() + begin, this->Known.begin() + begin + single.nodeCount());
    locks.angle.assign(
      this->Theta.begin() + begin, this->Theta.begin() + begin + single.nodeCount());
    AngleProblem problem = makeAngleProblem(single, std::move(locks));
    for (Index k = 0; k < single.nodeCount(); ++k)
    {
      problem.target[k] = this->Problem.target[begin + k];
      problem.length[single.edge[k]] = this->Problem.length[this->Net.edge[begin + k]];
    }
    const AngleSolution solution = solveAngles(problem, this->Options, this->Run);
    if (solution.status.code == StatusCode::Cancelled)
    {
      this->Result.angles.status = solution.status;
      return false;
    }
    for (Index k = 0; k < single.nodeCount(); ++k)
    {
      this->Theta[begin + k] = solution.theta[k];
      this->Known[begin + k] = 1;
    }
    this->Done[loop] = 1;
    this->Failed[loop] = solution.status.ok() ? 0 : 1;
    this->Result.warpingOrder.push_back(loop);
    this->Result.angles.iterations += solution.iterations;
    IterationRecord record = solution.history.empty() ? IterationRecord{} : solution.history.back();
    record.phase = "wire-patch";
    this->Result.angles.history.push_back(record);
    return true;
  }

  /// Lines 7 to 12 of Algorithm 2. Returns the loops whose evidence may have changed.
  Indices updateNeighbours(Index loop)
  {
    Indices changed;
    for (Index i = this->Net.loopBegin[loop]; i < this->Net.loopBegin[loop + 1]; ++i)
    {
      const Index host = this->Net.hostOfVertex[this->Net.vertex[i]];
      if (!this->Net.interior[host])
      {
        continue;
      }
      Index unknown = none;
      Index unknownCount = 0;
      double sum = 0.0;
      for (Index k = this->Net.vertexNodeBegin[host]; k < this->Net.vertexNodeBegin[host + 1]; ++k)
      {
        const Index node = this->Net.vertexNodes[k];
        if (this->Known[node])
        {
          sum += this->Theta[node];
        }
        else
        {
          unknown = node;
          ++unknownCount;
        }
      }
      if (unknownCount == 1)
      {
        this->Theta[unknown] = 2.0 * pi - sum; // Eq. 9
        this->Known[unknown] = 1;
        changed.push_back(this->Net.loop[unknown]);
      }
    }
    sortUnique(changed);
    eraseIf(changed, [this](Index l) { return this->Done[l] || this->Net.isHole(l); });
    return changed;
  }

  /// How far the turning and 2 pi constraints are from holding.
  double angularResidual() const
  {
    const Eigen::VectorXd all = AngleConstraints(this->Problem).residual(this->Theta);
    const Index closures = 3 * this->Net.loopCount();
    double worst = all.tail(all.size() - closures).lpNorm<Eigen::Infinity>();
    for (Index turning = 0; turning < closures; turning += 3)
    {
      worst = std::max(worst, std::abs(all[turning]));
    }
    return worst;
  }

  void finish()
  {
    AngleSolution& angles = this->Result.angles;
    angles.length = this->Problem.length;
    const double size = perimeter(this->Problem);
    angles.closure = closureResidual(this->Net, this->Theta, this->Problem.length);
    angles.theta = this->Theta;
    angles.objective = angleObjective(this->Problem, this->Theta);
    if (this->angularResidual() > 1e-10 || angles.closure > this->Options.closureTolerance * size)
    {
      this->findRepairTargets();
    }
  }

  /// What a patch that did not close was left with, or a vertex got by Eq. 9, may be many turns.
  void findRepairTargets()
  {
    this->Result.angles.status = { StatusCode::NotConverged,
      "the last wire-patches cannot be closed with the angles of those before", {} };
    for (Index i = 0; i < this->Net.nodeCount(); ++i)
    {
      const bool meant =
        !this->Failed[this->Net.loop[i]] && this->Theta[i] > 0.0 && this->Theta[i] < 2.0 * pi;
      this->Result.repairTargets.push_back(meant ? this->Theta[i] : this->Problem.target[i]);
    }
  }

  const AngleProblem& Problem;
  const WireNetwork& Net;
  const AngleSolverOptions& Options;
  const Execution& Run;
  std::vector<char> Known;
  std::vector<double> Theta;
  std::vector<char> Done;
  std::vector<char> Failed; ///< wire-patches that could not be closed
  ProgressiveSolution Result;
};
}

ProgressiveSolution warpProgressively(
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution)
{
  return Warping(problem, options, execution).run();
}
}
