// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/InteriorEmbedding.h"

#include "Base/Types.h"
#include "Embedding/InteriorSystem.h"
#include "Embedding/RigidEmbedding.h"

#include <algorithm>
#include <array>
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
    this->Rigid = std::make_unique<RigidEmbedding>(this->System, factor, this->Local, this->Run);
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
  if (options.method == InteriorMethod::AsRigidAsPossible &&
    (options.maximumRigidIterations < 1 || !std::isfinite(options.energyTolerance) ||
      options.energyTolerance < 0.0))
  {
    return invalidOption("the interior cannot be made as rigid as possible with these options",
      "at least one iteration and an energy tolerance that is not negative");
  }
  return {};
}

void summarize(const std::vector<std::unique_ptr<PatchEmbedding>>& patches, InteriorResult& result)
{
  std::array<Indices, 4> ended;
  for (const auto& patch : patches)
  {
    result.iterations = std::max(result.iterations, patch->iterations());
    ended[static_cast<std::size_t>(patch->outcome())].push_back(patch->patch());
  }
  const auto& [done, unconverged, stalled, failed] = ended;
  if (!failed.empty())
  {
    result.status = { StatusCode::NumericalFailure,
      "the inside of wire-patch " + listIds(failed) +
        " could not be placed; triangles of extremely different size are in its way",
      { ElementKind::WirePatches, failed }, { Remedy::MendSlivers } };
  }
  else if (!unconverged.empty())
  {
    result.status = { StatusCode::NotConverged,
      "the inside of wire-patch " + listIds(unconverged) + " is not yet as rigid as possible",
      { ElementKind::WirePatches, unconverged },
      { Remedy::AllowRigidIterations, Remedy::MendSlivers } };
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
  const auto eachPatch = [&](const auto& work) {
    if (alone)
    {
      work(0);
      return !execution.cancelled();
    }
    execution.forEachTask(static_cast<Index>(patches.size()), [&](Index i) { work(i); });
    return !execution.cancelled();
  };

  bool going = eachPatch([&](Index i) {
    if (renew)
    {
      systems.patches[i].update(std::move(renewed[i]), piece.mesh);
    }
    patches[i] = std::make_unique<PatchEmbedding>(systems.patches[i], positions, inner);
    if (rigid)
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
  summarize(patches, result);
  return result;
}
}
