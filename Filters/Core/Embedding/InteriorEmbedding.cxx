// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/InteriorEmbedding.h"

#include "Base/Types.h"
#include "Embedding/InteriorPatch.h"
#include "Embedding/RigidEmbedding.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace flattening
{
namespace
{
enum class Outcome
{
  Done,
  NotConverged,
  Stalled,
  Failed,
};

/// Neighbours of the interior vertices with the weights of Eq. 11, in flat arrays.
struct Neighbours
{
  Indices begin;
  Indices vertex;
  std::vector<double> weight;
};

Neighbours collectNeighbours(const InteriorPatch& patch, const std::vector<EdgeWeights>& weights)
{
  // All edges at an interior vertex have two triangles here: one sees the edge leave the vertex,
  // the other arrive, so those that leave are all, once.
  Neighbours result;
  result.begin.assign(patch.freeCount + 1, 0);
  for (const Triangle& c : patch.triangles)
  {
    for (Index v : c)
    {
      if (v < patch.freeCount)
      {
        ++result.begin[v + 1];
      }
    }
  }
  for (Index v = 0; v < patch.freeCount; ++v)
  {
    result.begin[v + 1] += result.begin[v];
  }
  Indices place(result.begin.begin(), result.begin.end() - 1);
  result.vertex.resize(result.begin.back());
  result.weight.resize(result.begin.back());
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index v = patch.triangles[t][k];
      if (v < patch.freeCount)
      {
        const Index at = place[v]++;
        result.vertex[at] = patch.triangles[t][(k + 1) % 3];
        result.weight[at] = 2.0 * weights[t][(k + 2) % 3];
      }
    }
  }
  return result;
}

/// Works on one wire-patch. Patches share nothing, so that they can run on any thread; one that
/// runs on the calling thread may use the others.
class PatchEmbedding
{
public:
  PatchEmbedding(InteriorSystem& system, const Points2& positions, const Execution& execution)
    : System(system)
    , Patch(system.patch())
    , Run(execution)
    , Local(static_cast<Eigen::Index>(Patch.vertices.size()), 2)
  {
    for (std::size_t i = 0; i < this->Patch.vertices.size(); ++i)
    {
      this->Local.row(static_cast<Eigen::Index>(i)) =
        positions[this->Patch.vertices[i]].transpose();
    }
  }

  /// Eq. 11 as a linear system.
  void solveLaplacian()
  {
    if (!this->System.solve(InteriorWeights::InverseLength, this->Run, this->Local))
    {
      this->Result = Outcome::Failed;
    }
  }

  /// Eq. 12: a sweep of SOR, in place and in the order of the vertices.
  void relax(const InteriorOptions& options, double smallest)
  {
    const Neighbours near =
      collectNeighbours(this->Patch, this->System.edgeWeights(InteriorWeights::InverseLength));
    this->Local.topRows(this->Patch.freeCount).rowwise() = this->wireCenter();
    while (this->Iterations < options.maximumIterations)
    {
      ++this->Iterations;
      double most = 0.0;
      for (Index v = 0; v < this->Patch.freeCount; ++v)
      {
        Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
        double total = 0.0;
        for (Index i = near.begin[v]; i < near.begin[v + 1]; ++i)
        {
          sum += near.weight[i] * this->Local.row(near.vertex[i]);
          total += near.weight[i];
        }
        const Eigen::RowVector2d move = options.relaxation * (sum / total - this->Local.row(v));
        this->Local.row(v) += move;
        most = std::max(most, move.norm());
      }
      if (this->Iterations >= options.minimumIterations && most < smallest)
      {
        return;
      }
    }
    this->Result = Outcome::NotConverged;
  }

  /// Starts from the harmonic map, whose matrix serves all that follows, or from that of Eq. 11
  /// where this turns fewer triangles over.
  void startRigid()
  {
    const bool harmonic = this->System.solve(InteriorWeights::Cotangent, this->Run, this->Local);
    const Index flipped = harmonic ? this->flippedCount() : 0;
    if (!harmonic || flipped > 0)
    {
      Eigen::MatrixXd other = this->Local;
      const bool means = this->System.solve(InteriorWeights::InverseLength, this->Run, this->Local);
      if (!means || (harmonic && this->flippedCount() >= flipped))
      {
        std::swap(other, this->Local);
      }
      if (!means && !harmonic)
      {
        this->Result = Outcome::Failed;
        return;
      }
    }
    const LinearSolver* const factor = this->System.factor(InteriorWeights::Cotangent, this->Run);
    if (!factor)
    {
      this->Result = Outcome::Stalled;
      return;
    }
    this->Rigid = std::make_unique<RigidEmbedding>(this->System, factor, this->Local);
    this->Running = true;
  }

  void iterateRigid(const InteriorOptions& options)
  {
    if (!this->Running)
    {
      return;
    }
    ++this->Iterations;
    const RigidEmbedding::State state = this->Rigid->iterate(options.energyTolerance);
    const bool exhausted = this->Iterations >= options.maximumRigidIterations;
    if (state != RigidEmbedding::State::Running || exhausted)
    {
      this->Running = false;
      if (state != RigidEmbedding::State::Converged)
      {
        this->Result =
          state == RigidEmbedding::State::Failed ? Outcome::Stalled : Outcome::NotConverged;
      }
      this->Local = this->Rigid->positions();
      this->Rigid.reset();
    }
  }

  void writeBack(Points2& positions) const
  {
    for (Index i = 0; i < this->Patch.freeCount; ++i)
    {
      positions[this->Patch.vertices[i]] = this->Local.row(i).transpose();
    }
  }

  Index patch() const { return this->Patch.patch; }
  Outcome outcome() const { return this->Result; }
  bool running() const { return this->Running; }
  int iterations() const { return this->Iterations; }

private:
  Eigen::RowVector2d wireCenter() const
  {
    const Eigen::Index wireCount = this->Local.rows() - this->Patch.freeCount;
    Eigen::RowVector2d center = Eigen::RowVector2d::Zero();
    for (Eigen::Index i = this->Patch.freeCount; i < this->Local.rows(); ++i)
    {
      center += this->Local.row(i) / static_cast<double>(wireCount);
    }
    return center;
  }

  Index flippedCount() const
  {
    return static_cast<Index>(std::count_if(
      this->Patch.triangles.begin(), this->Patch.triangles.end(), [this](const Triangle& t) {
        const Eigen::RowVector2d u = this->Local.row(t[1]) - this->Local.row(t[0]);
        const Eigen::RowVector2d v = this->Local.row(t[2]) - this->Local.row(t[0]);
        return !(cross(u, v) > 0.0);
      }));
  }

  InteriorSystem& System;
  const InteriorPatch& Patch;
  Execution Run;
  Eigen::MatrixXd Local;
  std::unique_ptr<RigidEmbedding> Rigid;
  Outcome Result = Outcome::Done;
  bool Running = false;
  int Iterations = 0;
};

Status checkOptions(const InteriorOptions& options)
{
  const auto invalid = [](const char* message, SuggestedRemedy suggested) {
    return Status{ StatusCode::InvalidOption, message, {}, { std::move(suggested) } };
  };
  if (options.method == InteriorMethod::Relaxation)
  {
    if (!std::isfinite(options.relaxation) || options.relaxation <= 0.0 ||
      options.relaxation >= 2.0)
    {
      return invalid("the relaxation factor lies outside its range",
        { Remedy::Give, "a number between 0 and 2, both excluded" });
    }
    if (options.minimumIterations < 0 || options.maximumIterations < 1 ||
      options.minimumIterations > options.maximumIterations || !std::isfinite(options.movement) ||
      options.movement < 0.0)
    {
      return invalid(
        "the relaxation cannot be run with these numbers of iterations, or this movement",
        Remedy::OrderRelaxation);
    }
  }
  if (options.method == InteriorMethod::AsRigidAsPossible &&
    (options.maximumRigidIterations < 1 || !std::isfinite(options.energyTolerance) ||
      options.energyTolerance < 0.0))
  {
    return invalid("the interior cannot be made as rigid as possible with these options",
      { Remedy::Give, "at least one iteration and an energy tolerance that is not negative" });
  }
  return {};
}

double meanWireEdge(const WireNetwork& network)
{
  double sum = 0.0;
  for (const WireEdge& edge : network.edges)
  {
    sum += edge.length;
  }
  return network.edges.empty() ? 0.0 : sum / static_cast<double>(network.edges.size());
}

/// What is still to be done to patches that ran out of iterations.
Status unfinished(InteriorMethod method, const Indices& patches)
{
  const bool relaxation = method == InteriorMethod::Relaxation;
  return { StatusCode::NotConverged,
    relaxation
      ? "the relaxation of the inside of wire-patch " + listIds(patches) +
        " did not come to rest in the iterations that are allowed"
      : "the inside of wire-patch " + listIds(patches) + " is not yet as rigid as possible",
    { ElementKind::WirePatches, patches },
    relaxation ? SuggestedRemedies{ Remedy::AllowRelaxationIterations }
               : SuggestedRemedies{ Remedy::AllowRigidIterations, Remedy::MendSlivers } };
}

void summarize(const std::vector<std::unique_ptr<PatchEmbedding>>& patches, InteriorMethod method,
  InteriorResult& result)
{
  Indices failed;
  Indices unconverged;
  Indices stalled;
  for (const auto& patch : patches)
  {
    result.iterations = std::max(result.iterations, patch->iterations());
    if (patch->outcome() == Outcome::Failed)
    {
      failed.push_back(patch->patch());
    }
    else if (patch->outcome() == Outcome::NotConverged)
    {
      unconverged.push_back(patch->patch());
    }
    else if (patch->outcome() == Outcome::Stalled)
    {
      stalled.push_back(patch->patch());
    }
  }
  if (!failed.empty())
  {
    result.status = { StatusCode::NumericalFailure,
      "the inside of wire-patch " + listIds(failed) +
        " could not be placed; triangles of extremely different size are in its way",
      { ElementKind::WirePatches, failed }, { Remedy::MendSlivers } };
  }
  else if (!unconverged.empty())
  {
    result.status = unfinished(method, unconverged);
  }
  else if (!stalled.empty())
  {
    result.status = { StatusCode::NotConverged,
      "the inside of wire-patch " + listIds(stalled) +
        " is not as rigid as possible, and no step makes it so",
      { ElementKind::WirePatches, stalled }, { Remedy::MendSlivers } };
  }
}
}

InteriorResult embedInterior(const Piece& piece, const WireNetwork& network,
  const InteriorOptions& options, const Execution& execution, Points2& positions,
  InteriorSystems* kept)
{
  InteriorResult result;
  result.status = checkOptions(options);
  if (!result.status.ok())
  {
    return result;
  }
  InteriorSystems own;
  InteriorSystems& systems = kept ? *kept : own;
  std::vector<InteriorPatch> renewed;
  const bool renew = !systems.current;
  if (renew)
  {
    renewed = collectInteriorPatches(piece, network);
    systems.patches.resize(renewed.size());
  }
  const bool alone = systems.patches.size() == 1;
  const Execution inner = alone ? execution : Execution();
  std::vector<std::unique_ptr<PatchEmbedding>> patches(systems.patches.size());
  const bool rigid = options.method == InteriorMethod::AsRigidAsPossible;
  const double smallest = options.movement * meanWireEdge(network);
  const auto eachPatch = [&](const auto& work) {
    if (alone)
    {
      work(0);
      return !execution.cancelled();
    }
    execution.parallelFor(static_cast<Index>(patches.size()), [&](Index begin, Index end) {
      for (Index i = begin; i < end; ++i)
      {
        work(i);
      }
    });
    return !execution.cancelled();
  };

  bool going = eachPatch([&](Index i) {
    if (renew)
    {
      systems.patches[i].update(std::move(renewed[i]), piece.mesh);
    }
    patches[i] = std::make_unique<PatchEmbedding>(systems.patches[i], positions, inner);
    if (options.method == InteriorMethod::Relaxation)
    {
      patches[i]->relax(options, smallest);
    }
    else if (rigid)
    {
      patches[i]->startRigid();
    }
    else
    {
      patches[i]->solveLaplacian();
    }
    if (!kept && !rigid)
    {
      systems.patches[i].forgetFactors();
    }
  });
  systems.current = going;
  const auto running = [](const auto& patch) { return patch->running(); };
  while (going && std::any_of(patches.begin(), patches.end(), running))
  {
    going = eachPatch([&](Index i) {
      patches[i]->iterateRigid(options);
      if (!kept && !patches[i]->running())
      {
        systems.patches[i].forgetFactors();
      }
    });
  }
  if (!going)
  {
    systems = {};
    result.status = { StatusCode::Cancelled, "cancelled while placing the interior", {} };
    return result;
  }
  for (const auto& patch : patches)
  {
    patch->writeBack(positions);
  }
  summarize(patches, options.method, result);
  return result;
}
}
