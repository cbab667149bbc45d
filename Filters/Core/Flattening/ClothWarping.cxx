// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/ClothWarping.h"

#include "Base/Types.h"
#include "Cloth/ClothMeasures.h"
#include "Flattening/GrainPlacement.h"
#include "Quality/FlatteningQuality.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// Of what is beyond a limit over the stiffer thread. More takes back little more of what exact
/// lengths force, and takes Newton's method longer.
constexpr double limitStiffness = 10.0;
/// Of wires, as a fraction. Rough starts miss them by less than they end with where slivers break.
constexpr double brokenLength = 1e-6;
/// Angles of a free grain that are tried, over the half turn after which they repeat.
constexpr int triedAngles = 8;
const char* const alreadySo = " without the material already, which no cloth can follow";
/// Angles of a sheet that is only turned.
constexpr int measuredAngles = 180;

/// A piece on its way onto a cloth.
class ClothWarping
{
public:
  ClothWarping(const PieceContext& context, const WireSolution& wires, PlacedPiece& placed)
    : Context(context)
    , Cloth(*context.options.cloth)
    , Wires(wires)
    , Placed(placed)
    , Reference(context, placed.positions)
  {
  }

  void run()
  {
    const bool solves = this->Placed.isometric && !this->Cloth.material.isotropic;
    if (!solves)
    {
      this->Placed.positions =
        this->turned(this->isFree() ? this->leastStrainedAngle() : this->Reference.asked());
    }
    else if (countFlipped(this->Context.piece.mesh, this->Placed.positions) > 0)
    {
      this->layAsItIs(std::string("triangles are turned over") + alreadySo);
    }
    else
    {
      this->take(this->isFree() ? this->solveFree()
                                : this->solveAt(this->Reference.asked(), this->Placed.positions,
                                    this->Placed.isometric->stretch));
    }
    this->Placed.grain = this->Reference.report(this->Context, this->Placed.positions);
  }

private:
  bool isFree() const { return this->Cloth.grain == GrainKind::Free; }

  void layAsItIs(const std::string& why, Remedy remedy = Remedy::AddDarts)
  {
    this->Placed.positions = this->turned(this->isFree() ? 0.0 : this->Reference.asked());
    noteStatus(
      { StatusCode::NotConverged, why + "; it was laid on the piece as that is", {}, { remedy } },
      this->Placed.status);
  }

  Points2 turned(double angle) const
  {
    return this->Reference.turned(angle, this->Placed.positions);
  }

  IsometricSolution solve(const Points2& start, const std::vector<double>& stretch, double limits,
    bool rough, const GrainHold& hold) const
  {
    IsometricOptions options = this->Context.options.isometric;
    options.cloth = ClothSheet{ this->Cloth.material, limits, hold };
    options.rough = rough;
    return warpIsometrically(this->Context.piece, this->Wires.problem, start, stretch, options,
      this->Context.execution.part(1.0, 1.0));
  }

  IsometricSolution solveAt(
    double angle, const Points2& positions, const std::vector<double>& stretch) const
  {
    const Points2 start = this->Reference.turned(angle, positions);
    return this->solve(start, stretch, limitStiffness, false, this->Reference.hold(start));
  }

  static IsometricSolution together(const IsometricSolution& first, IsometricSolution last)
  {
    last.history.insert(last.history.begin(), first.history.begin(), first.history.end());
    last.iterations += first.iterations;
    return last;
  }

  IsometricSolution solveFree() const
  {
    std::vector<double> energy;
    IsometricSolution best;
    int chosen = 0;
    for (int k = 0; k < triedAngles; ++k)
    {
      const Points2 start = this->Reference.turned(pi * k / triedAngles, this->Placed.positions);
      IsometricSolution tried = this->solve(
        start, this->Placed.isometric->stretch, limitStiffness, true, this->Reference.hold(start));
      if (tried.status.refused())
      {
        return tried;
      }
      energy.push_back(tried.distortionEnergy);
      if (k == 0 || energy.back() < energy[static_cast<std::size_t>(chosen)])
      {
        chosen = k;
        best = std::move(tried);
      }
    }
    const double angle = pi * (chosen + vertexOfParabola(energy, chosen)) / triedAngles;
    return together(best, this->solveAt(angle, best.positions, best.stretch));
  }

  /// Where the parabola through a least value and its neighbours is least, in steps from it.
  static double vertexOfParabola(const std::vector<double>& values, int least)
  {
    const auto at = [&](int k) {
      const auto count = static_cast<int>(values.size());
      return values[static_cast<std::size_t>((k + count) % count)];
    };
    const double bend = at(least - 1) - 2.0 * at(least) + at(least + 1);
    return bend > 0.0 ? 0.5 * (at(least - 1) - at(least + 1)) / bend : 0.0;
  }

  double leastStrainedAngle() const
  {
    double least = std::numeric_limits<double>::infinity();
    double chosen = 0.0;
    std::vector<TriangleFrame> frames;
    const TriangleMesh& mesh = this->Context.piece.mesh;
    for (const Triangle& c : mesh.triangles())
    {
      frames.emplace_back(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2]));
    }
    for (int k = 0; k < measuredAngles; ++k)
    {
      const double angle = pi * k / measuredAngles;
      const ClothSummary threads = summarizeThreads(frames,
        measureThreads(frames, mesh.triangles(), this->turned(angle)), this->Cloth.material);
      const double strain = std::hypot(threads.warpRms, threads.weftRms);
      if (strain < least)
      {
        least = strain;
        chosen = angle;
      }
    }
    return chosen;
  }

  void take(IsometricSolution solution)
  {
    IsometricSolution& before = *this->Placed.isometric;
    if (solution.status.refused())
    {
      this->Placed.status = solution.status;
      return;
    }
    if (!std::isfinite(solution.distortionEnergy))
    {
      this->layAsItIs(std::string("triangles are pressed to nothing") + alreadySo);
      return;
    }
    const double error = this->largestLengthError(solution.positions, solution.stretch);
    if (!(error <= brokenLength) &&
      !(error <= this->largestLengthError(this->Placed.positions, before.stretch)))
    {
      this->layAsItIs(
        "on the material its wires would miss their lengths between slivers", Remedy::MendSlivers);
      return;
    }
    solution.history.insert(solution.history.begin(), before.history.begin(), before.history.end());
    solution.iterations += before.iterations;
    before = std::move(solution);
    this->Placed.positions = before.positions;
    this->Placed.energyUsed = this->Context.options.isometric.energy.kind;
    this->Placed.clothSolved = true;
    if (this->Placed.status.code == StatusCode::NotConverged)
    {
      this->Placed.status = {}; // of what was only the start
    }
    noteStatus(before.status, this->Placed.status);
  }

  /// As a fraction of a wire edge's length.
  double largestLengthError(const Points2& positions, const std::vector<double>& stretch) const
  {
    const AngleProblem& problem = this->Wires.problem;
    double worst = 0.0;
    for (Index e = 0; e < problem.network->edgeCount(); ++e)
    {
      const WireEdge& edge = problem.network->edges[e];
      if (edge.connector || !(problem.length[e] > 0.0))
      {
        continue;
      }
      const Index group = problem.stretchGroup[e];
      const double wanted = problem.length[e] * (group == none ? 1.0 : 1.0 + stretch[group]);
      worst = std::max(
        worst, std::abs((positions[edge.to] - positions[edge.from]).norm() / wanted - 1.0));
    }
    return worst;
  }

  const PieceContext& Context;
  const ClothOptions& Cloth;
  const WireSolution& Wires;
  PlacedPiece& Placed;
  const GrainReference Reference;
};
}

void layOnCloth(const PieceContext& context, const WireSolution& wires, PlacedPiece& placed)
{
  if (context.options.cloth && !placed.status.refused() && !placed.positions.empty())
  {
    ClothWarping(context, wires, placed).run();
  }
}
}
