// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/Untangling.h"

#include "Embedding/DistortionEnergy.h"
#include "Embedding/InteriorSystem.h"
#include "Quality/FlatteningQuality.h"
#include "Sparse/LinearSolver.h"
#include "Sparse/NewtonKktStep.h"
#include "Sparse/SymmetricAssembler.h"
#include "Surface/TriangleFrame.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
constexpr double areaWeight = 1.0 / 128.0; ///< of the area term beside the shape term
/// Iterations times triangles, so that time is bounded on every mesh, and between which limits: the
/// fewest let most patches of any size end without folds.
constexpr double maxTriangles = 4e6;
constexpr int maxIterations = 200;
constexpr int fewestIterations = 20;
/// From this number of interior vertices on a factorization by blocks pays.
constexpr Index manyVertices = 400;
/// Around a single flipped triangle.
constexpr int fewestRings = 4;

double determinant(const Eigen::Vector4d& parts)
{
  return 0.25 * (parts.head<2>().squaredNorm() - parts.tail<2>().squaredNorm());
}

/// A positive stand-in for the determinant.
double regularized(double epsilon, double det)
{
  const double root = std::sqrt(epsilon * epsilon + det * det);
  // Without cancellation where det < 0.
  return det >= 0.0 ? 0.5 * (det + root) : 0.5 * epsilon * epsilon / (root - det);
}

/// (|J|^2 + w (det^2 + 1)) / chi(epsilon, det)
NormDetDensity density(double epsilon, const Eigen::Vector4d& parts)
{
  const double norm = 0.5 * parts.squaredNorm();
  const double det = determinant(parts);
  const double root = std::sqrt(epsilon * epsilon + det * det);
  const double chi = std::max(regularized(epsilon, det), 1e-150);
  const double slope = chi / root;
  const double bend = 0.5 * epsilon * epsilon / (root * root * root);
  const double top = norm + areaWeight * (det * det + 1.0);
  const double topByDet = 2.0 * areaWeight * det;
  const double r = slope / chi; // chi' / chi
  NormDetDensity d;
  d.value = top / chi;
  d.byNorm = 1.0 / chi;
  d.byDet = (topByDet - top * r) / chi;
  d.byNormDet = -r / chi;
  d.byDet2 = (2.0 * areaWeight - 2.0 * topByDet * r - top * (bend / chi - 2.0 * r * r)) / chi;
  return d;
}

/// The part of a patch in some rings of vertices around its flipped triangles; more of them
/// need more room.
InteriorPatch aroundFolds(
  const InteriorPatch& patch, const TriangleMesh& mesh, const Points2& positions)
{
  std::vector<char> within(patch.vertices.size(), 0);
  int folds = 0;
  for (const Triangle& c : patch.triangles)
  {
    const Triangle corners{ patch.vertices[c[0]], patch.vertices[c[1]], patch.vertices[c[2]] };
    const Eigen::Vector4d parts = mapParts(TriangleFrame(mesh.points(), corners), corners,
      [&positions](Index v) { return positions[v]; });
    if (determinant(parts) <= 0.0)
    {
      ++folds;
      std::for_each(c.begin(), c.end(), [&within](Index v) { within[v] = 1; });
    }
  }
  const int rings = folds == 0 ? 0 : fewestRings + static_cast<int>(2.0 * std::sqrt(folds));
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<char> before = within;
    for (const Triangle& c : patch.triangles)
    {
      if (before[c[0]] || before[c[1]] || before[c[2]])
      {
        std::for_each(c.begin(), c.end(), [&within](Index v) { within[v] = 1; });
      }
    }
  }
  return restrictedTo(patch, within);
}

class PatchUntangling
{
public:
  PatchUntangling(const InteriorPatch& patch, const TriangleMesh& mesh, const Points2& positions)
    : Patch(patch)
    , X(2 * static_cast<Eigen::Index>(patch.vertices.size()))
    , Assembler(2 * patch.freeCount)
  {
    for (std::size_t i = 0; i < patch.vertices.size(); ++i)
    {
      this->X.segment<2>(2 * static_cast<Eigen::Index>(i)) = positions[patch.vertices[i]];
      this->Space.push_back(mesh.point(patch.vertices[i]));
    }
    for (const Triangle& c : patch.triangles)
    {
      this->Frames.emplace_back(this->Space, c);
    }
  }

  bool tangled() const { return this->flips(this->X) > 0; }

  /// True where the run was not cancelled.
  bool run(const Execution& execution, int patience)
  {
    this->Run = execution;
    this->declareBlocks();
    Eigen::VectorXd best = this->X;
    Index fewest = this->flips(best);
    int since = 0;
    double epsilon = 1.0;
    const int iterations =
      static_cast<int>(std::clamp(maxTriangles / static_cast<double>(this->Frames.size()),
        double{ fewestIterations }, double{ maxIterations }));
    for (int iteration = 0; iteration < iterations && since < patience; ++iteration)
    {
      if (execution.cancelled())
      {
        return false;
      }
      double before = 0.0;
      double after = 0.0;
      if (!this->step(epsilon, before, after))
      {
        break;
      }
      const Index flipped = this->flips(this->X);
      since = flipped < fewest || flipped == 0 ? 0 : since + 1;
      if (flipped < fewest || (flipped == 0 && fewest == 0))
      {
        fewest = flipped;
        best = this->X;
      }
      if (flipped == 0 && before - after <= 1e-4 * before)
      {
        break;
      }
      epsilon = this->nextEpsilon(epsilon, before, after);
    }
    this->X = best;
    return true;
  }

  void writeBack(Points2& positions) const
  {
    for (Index i = 0; i < this->Patch.freeCount; ++i)
    {
      positions[this->Patch.vertices[i]] = this->X.segment<2>(2 * i);
    }
  }

private:
  Eigen::Vector4d parts(std::size_t t, const Eigen::VectorXd& x) const
  {
    return mapParts(
      this->Frames[t], this->Patch.triangles[t], [&x](Index v) { return x.segment<2>(2 * v); });
  }

  Index flips(const Eigen::VectorXd& x) const
  {
    Index count = 0;
    for (std::size_t t = 0; t < this->Frames.size(); ++t)
    {
      count += determinant(this->parts(t, x)) <= 0.0 ? 1 : 0;
    }
    return count;
  }

  double energy(double epsilon, const Eigen::VectorXd& x) const
  {
    double sum = 0.0;
    for (std::size_t t = 0; t < this->Frames.size(); ++t)
    {
      sum += this->Frames[t].area * density(epsilon, this->parts(t, x)).value;
    }
    return sum;
  }

  void declareBlocks()
  {
    this->Blocks.reserve(this->Patch.triangles.size());
    for (const Triangle& c : this->Patch.triangles)
    {
      std::array<Index, 6> unknowns{};
      for (int a = 0; a < 6; ++a)
      {
        const Index vertex = c[a / 2];
        unknowns[a] = vertex < this->Patch.freeCount ? 2 * vertex + a % 2 : none;
      }
      this->Blocks.emplace_back(this->Assembler, unknowns);
    }
    this->Assembler.finish();
    if (this->Patch.freeCount >= manyVertices)
    {
      // By where the vertices lie on the surface.
      this->Solver =
        LinearSolver(dissect(this->Patch.triangles, this->Space).ofUnknowns(2, [this](Index v) {
          return v < this->Patch.freeCount ? 2 * v : none;
        }));
    }
  }

  /// One projected Newton step with backtracking; false where it leads nowhere. Gives the energy
  /// on both sides of it.
  bool step(double epsilon, double& before, double& after)
  {
    const Eigen::Index unknowns = 2 * this->Patch.freeCount;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(unknowns);
    before = 0.0;
    this->Assembler.clear();
    for (std::size_t t = 0; t < this->Frames.size(); ++t)
    {
      const double area = this->Frames[t].area;
      const Eigen::Matrix<double, 4, 6> derivative = mapPartsDerivative(this->Frames[t]);
      const Eigen::Vector4d at = this->parts(t, this->X);
      const DistortionEnergyValue value = expandNormDet(density(epsilon, at), at, true);
      before += area * value.value;
      const Eigen::Matrix<double, 6, 1> g = area * (derivative.transpose() * value.gradient);
      const Eigen::Matrix<double, 6, 6> H =
        area * (derivative.transpose() * value.hessian * derivative);
      this->Blocks[t].scatter(g, gradient);
      this->Blocks[t].add(this->Assembler, H);
    }
    if (!this->Solver.factorize(this->Assembler.matrix(), this->Run) ||
      this->Solver.positive() != unknowns)
    {
      return false;
    }
    const Eigen::MatrixXd direction = this->Solver.solve(-gradient);
    if (direction.rows() != unknowns)
    {
      return false;
    }
    const double slope = gradient.dot(direction.col(0));
    double scale = 1.0;
    for (int halving = 0; halving < maximumHalvings; ++halving, scale *= 0.5)
    {
      Eigen::VectorXd trial = this->X;
      trial.head(unknowns) += scale * direction.col(0);
      after = this->energy(epsilon, trial);
      if (after < before + sufficientDecrease * scale * slope)
      {
        this->X = std::move(trial);
        return true;
      }
    }
    return false;
  }

  /// The rule of the method: as small as the worst triangle and the progress allow.
  double nextEpsilon(double epsilon, double before, double after) const
  {
    double worst = determinant(this->parts(0, this->X));
    for (std::size_t t = 1; t < this->Frames.size(); ++t)
    {
      worst = std::min(worst, determinant(this->parts(t, this->X)));
    }
    const double sigma = std::max(1.0 - after / before, 0.1);
    const double goal = (1.0 - sigma) * regularized(epsilon, worst);
    return worst < goal ? 2.0 * std::sqrt(goal * (goal - worst)) : 1e-10;
  }

  const InteriorPatch& Patch;
  Eigen::VectorXd X;
  Points3 Space; ///< on the surface
  TriangleFrames Frames;
  SymmetricAssembler Assembler;
  std::vector<SymmetricBlock<6>> Blocks; ///< of the triangles, without what is pinned
  LinearSolver Solver;
  Execution Run;
};
}

UntanglingResult untangleInterior(const Piece& piece, const WireNetwork& network,
  const Execution& execution, Points2& positions, const UntanglingOptions& options)
{
  UntanglingResult result;
  if (countFlipped(piece.mesh, positions) == 0)
  {
    return result;
  }
  const std::vector<InteriorPatch> patches = collectInteriorPatches(piece, network);
  enum class Outcome : char
  {
    Sound,
    Untangled,
    Tangled,
    Cancelled,
  };
  std::vector<Outcome> outcomes(patches.size(), Outcome::Sound);
  const auto untangle = [&](Index k, const Execution& run) {
    const InteriorPatch part =
      options.nearby ? aroundFolds(patches[k], piece.mesh, positions) : patches[k];
    PatchUntangling patch(part, piece.mesh, positions);
    if (patch.tangled())
    {
      const bool done = patch.run(run, options.patience);
      patch.writeBack(positions); // vertices of this patch alone
      outcomes[k] = !done ? Outcome::Cancelled
        : patch.tangled() ? Outcome::Tangled
                          : Outcome::Untangled;
    }
  };
  if (patches.size() == 1)
  {
    untangle(0, execution);
  }
  else
  {
    const Execution inner = execution.nestedExecution();
    execution.forEachTask(static_cast<Index>(patches.size()), [&](Index k) { untangle(k, inner); });
  }
  for (std::size_t k = 0; k < patches.size(); ++k)
  {
    if (outcomes[k] == Outcome::Cancelled)
    {
      result.status = { StatusCode::Cancelled, "cancelled while untangling", {} };
    }
    if (outcomes[k] != Outcome::Sound)
    {
      result.patches.push_back(patches[k].patch);
    }
    if (outcomes[k] == Outcome::Tangled)
    {
      result.tangled.push_back(patches[k].patch);
    }
  }
  return result;
}
}
