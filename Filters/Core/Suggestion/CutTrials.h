// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"
#include "Imprint/ImprintedSurface.h"
#include "Sparse/LinearSolver.h"
#include "Surface/FeatureCurve.h"
#include "Surface/RegionWeights.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace flattening
{
/// What each cut is to lower.
enum class SearchGoal
{
  Energy, ///< the rigid energy
  Area,   ///< the mean change of area
  Strain  ///< the mean of the strain's fourth power, which tells of the largest
};

/// What a search may spend on flattenings. Their work is counted, not timed, so that a search that
/// is ended by it has the same result wherever it is made.
class TrialBudget
{
public:
  /// \param most as TrialOutcome::work counts it
  explicit TrialBudget(double most)
    : Most(most)
  {
  }
  /// A share of another budget, which pays as well.
  TrialBudget(double most, TrialBudget& whole)
    : Most(most)
    , Whole(&whole)
  {
  }
  /// Hands on the part of the work that is done with each payment.
  void watch(std::function<void(double)> watcher) { this->Watcher = std::move(watcher); }

  bool spent() const { return this->Paid >= this->Most; }
  double left() const { return this->Most - this->Paid; }
  /// Paid so far.
  double work() const { return this->Paid; }
  Index trials() const { return this->Trials; }

  void pay(double work)
  {
    for (TrialBudget* budget = this; budget; budget = budget->Whole)
    {
      budget->Paid += work;
      ++budget->Trials;
      if (budget->Watcher)
      {
        budget->Watcher(std::min(1.0, budget->Paid / budget->Most));
      }
    }
  }

private:
  double Most;
  double Paid = 0.0;
  Index Trials = 0;
  TrialBudget* Whole = nullptr;
  std::function<void(double)> Watcher;
};

/// What cloth between the branches of pieces costs that is as large as the surface, in the price of
/// cuts. Beside no price, 6 takes a tenth to three fifths of the waste of seven garments, hats and
/// barrels, at a price of seams within a tenth; 4 left more, and with 10 there were more pieces.
constexpr double wastePrice = 6.0;

/// Budgets are checked after this many trials in parallel, more than there are threads.
inline constexpr Index triedTogether = 16;

/// What a flattening with some cuts turned out to be. Where regions have weights, energy, goal and
/// strain are as if areas were multiplied by them.
struct TrialOutcome
{
  bool valid = false;      ///< there is a flattening, and no cut touches a key curve inside
  double energy = 0.0;     ///< rigid energy times area, over all pieces
  double goal = 0.0;       ///< what the search is to lower, over all pieces
  double strainP95 = 0.0;  ///< of the piece where it is largest
  double areaError = 0.0;  ///< mean over the pieces by area
  std::size_t flipped = 0; ///< triangles, those that have collapsed as well
  std::size_t overlaps = 0;
  std::vector<double> lengths; ///< by cut
  /// By piece, in the order of their smallest triangles.
  std::vector<double> pieceStrains;
  std::vector<double> pieceGoals;
  std::vector<double> pieceAreas; ///< over that of all
  std::vector<char> pieceFaults;  ///< whether it is folded or lies over another part

  double waste = 0.0;    ///< area of the pieces' convex hulls beyond their own
  double minPiece = 1.0; ///< area of the smallest piece over that of all
  int severity = 0;      ///< of its status
  /// Where the strain is largest of what counts.
  Point3 worstPlace = Point3::Zero();

  double cutLength() const;
  /// One of the measures; NaN where there is no flattening to measure.
  double valueOrNaN(double measure) const
  {
    return this->valid ? measure : std::numeric_limits<double>::quiet_NaN();
  }
  /// Whether a piece is within a bound of the strain, and neither folded nor over another part; of
  /// a bound of 0, which stands for none, no piece is.
  bool keeps(std::size_t piece, double bound) const
  {
    return bound > 0.0 && this->pieceStrains[piece] <= bound && !this->pieceFaults[piece];
  }
  /// How many pieces are folded or lie over another part.
  std::ptrdiff_t faults() const
  {
    return std::count(this->pieceFaults.begin(), this->pieceFaults.end(), 1);
  }
  /// Whether all pieces are.
  bool keeps(double bound) const
  {
    return bound > 0.0 && this->valid && this->strainP95 <= bound && this->faults() == 0;
  }
  /// Whether the status is no worse than before: nothing more is folded or lies over another part.
  bool soundAfter(const TrialOutcome& before) const
  {
    return this->valid && this->severity <= before.severity && this->flipped <= before.flipped &&
      this->overlaps <= before.overlaps;
  }
};

/// By triangle.
std::vector<FlatCorners> cornersOf(const FlatteningResult& flat);

/// Lines and more of them.
std::vector<Polyline> withLines(std::vector<Polyline> lines, const std::vector<Polyline>& more);

/// Options of flattenings that are only compared with each other: energies are known to five digits
/// long before the last iterations, and the legs of darts are free.
FlatteningOptions roughly(FlatteningOptions options);

/// Flattens one surface with the curves that it has anyway and with cuts on trial.
class CutTrials
{
public:
  /// The mesh must outlive it. \param maxSteps after which a trial with cuts is given up, by far
  /// more than sound ones take
  CutTrials(const TriangleMesh& mesh, std::vector<Polyline> curves, const ImprintOptions& imprint,
    const FlatteningOptions& flattening, SearchGoal goal = SearchGoal::Energy,
    RegionWeights weights = {}, double maxSteps = std::numeric_limits<double>::infinity());

  /// One flattening. The outcome is not valid where the budget ends it.
  struct Trial
  {
    ImprintedSurface surface;
    FlatteningResult flat;
    TrialOutcome outcome;
    double work = 0.0; ///< unknowns of all systems that were solved, and what else there is to do
  };
  /// Of as many steps as these, each of a system with an unknown for each triangle.
  double workOf(double steps) const
  {
    return steps * factorizationWork(static_cast<double>(this->Mesh.triangleCount()));
  }
  Trial trial(
    const std::vector<Polyline>& cuts, TrialBudget& budget, const Execution& execution) const;
  TrialOutcome run(
    const std::vector<Polyline>& cuts, TrialBudget& budget, const Execution& execution) const
  {
    return this->trial(cuts, budget, execution).outcome;
  }
  /// The surface without any cut. From then on trials start from where that has put it, but for
  /// those that keep it from overlapping.
  TrialOutcome startUncut(TrialBudget& budget, const Execution& execution);
  /// From then on trials start from there. \param start by triangle of the mesh; empty: anew
  void startFrom(std::vector<FlatCorners> start) { this->Start = std::move(start); }
  bool foldsDarts() const { return this->Flattening.foldsDarts(); }
  /// The surface with its curves and the cuts. Where these can be laid into it, but may not, as
  /// they cross or part what darts may not, it is there and its status is StatusCode::InvalidCurve.
  ImprintedSurface imprinted(const std::vector<Polyline>& cuts) const;
  /// By cut, the points where it crosses the edges of the surface; none where it cannot be made.
  std::vector<Points3> paths(const std::vector<Polyline>& cuts) const;
  /// Several, in parallel; an empty set of cuts is not tried, and none once the budget is spent.
  std::vector<TrialOutcome> runAll(const std::vector<std::vector<Polyline>>& cuts,
    TrialBudget& budget, const Execution& execution) const;

private:
  Trial tried(const std::vector<Polyline>& cuts, double most, const Execution& execution) const;
  TrialOutcome measured(const ImprintedSurface& surface, const FlatteningResult& flat) const;
  std::vector<FlatCorners> startOf(const ImprintedSurface& surface) const;

  const TriangleMesh& Mesh;
  std::vector<Polyline> Curves;
  ImprintOptions Imprint;
  FlatteningOptions Flattening;
  SearchGoal Goal;
  RegionWeights Weights; ///< of Mesh
  double MostSteps;
  std::vector<FlatCorners> Start; ///< by triangle of Mesh; empty: trials start anew
};
}
