// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutAdjustment.h"

#include "Imprint/CurveImprint.h"
#include "Suggestion/CutSetMerit.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/MovedPlans.h"
#include "Suggestion/PieceImages.h"
#include "Suggestion/PlannedCut.h"
#include "Suggestion/SettledCuts.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// In sqrt(area / pi): how far ends are moved at first, and at last.
constexpr double firstMove = 0.12;
constexpr double lastMove = 0.015;
/// Moves are taken that lower the merit, a logarithm, by more than this.
constexpr double leastFall = 0.002;
/// Ends this near to the boundary, in the same unit, lie on it.
constexpr double onPlace = 1e-6;
/// A seam that cuts off less than this share of the area is no seam.
constexpr double leastShareOff = 0.03;
/// Of the most length, what is left for ends that move onto vertices.
constexpr double lengthToSpare = 1e-4;

std::vector<Polyline> withFirst(
  std::vector<Polyline> curves, const std::vector<SuggestedCurve>& cuts, std::size_t count)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    curves.push_back(cuts[k].curve);
  }
  return curves;
}

/// What a share of strain above the bound weighs against one of the price; within it they weigh
/// alike.
constexpr double unmetWeight = 10.0;

/// Closing cuts takes many flattenings: it is left to so many of the moves that promise most
/// without.
constexpr std::size_t mostClosed = 2;

FlatteningOptions quickly(FlatteningOptions options)
{
  options.closeCuts = false;
  return roughly(std::move(options));
}

/// Of the work, what moving may take where cuts are then to be taken back.
constexpr double movingShare = 0.75;

class Adjusting
{
public:
  Adjusting(const SearchSubject& subject, std::size_t firstCount, CutSet& set, TrialBudget& budget,
    const Execution& execution)
    : Subject(subject)
    , Search(subject.search)
    , Run(execution)
    , Trials(subject.mesh, subject.curves, subject.imprint, subject.flattening, subject.search.goal,
        subject.weights)
    , Quick(subject.mesh, withFirst(subject.curves, set.cuts, firstCount), subject.imprint,
        quickly(subject.flattening), subject.search.goal, subject.weights)
    , Budget(budget)
    , FirstCount(firstCount)
    , Set(set)
    , Longest(subject.search.maximumCutLength)
    , LeftToThin(subject.search.bound > 0.0 ? (1.0 - movingShare) * budget.left() : 0.0)
  {
    this->Size = std::sqrt(subject.mesh.area() / pi);
    if (set.outcome.energy > 0.0 && set.outcome.strainP95 > 0.0)
    {
      this->QuantileOverMean = set.outcome.strainP95 / std::sqrt(set.outcome.energy);
    }
    if (subject.search.bound == 0.0 && !std::isfinite(this->Longest))
    {
      this->Longest = set.outcome.cutLength();
    }
  }

  void run()
  {
    this->Quick.startUncut(this->Budget, this->Run);
    for (double step = firstMove; step >= lastMove && this->goesOn();)
    {
      bool better = false;
      for (std::size_t k = this->FirstCount; k < this->Set.cuts.size() && this->goesOn(); ++k)
      {
        better = (this->Set.cuts[k].mirrorOf == none && this->move(k, step * this->Size)) || better;
      }
      step *= better ? 1.0 : 0.5;
      this->Run.report(
        std::log(firstMove / step) / std::log(2.0 * firstMove / lastMove), "Moving cuts");
    }
    if (this->FirstCount == 0 && this->met(this->Set.outcome))
    {
      thinCuts(this->Trials, this->Search.bound, this->Search.leastLength * this->Size,
        this->Set.cuts, this->Set.outcome, this->Budget, this->Run);
      this->takeLengths();
    }
    if (this->met(this->Set.outcome))
    {
      this->Set.end = SearchEnd::BoundMet;
    }
  }

private:
  bool goesOn() const { return this->Budget.left() > this->LeftToThin && !this->Run.cancelled(); }

  void takeLengths()
  {
    for (std::size_t k = 0; k < this->Set.cuts.size(); ++k)
    {
      this->Set.cuts[k].length = this->Set.outcome.lengths[k];
    }
  }

  /// Once the bound is met no more length is spent: it is there to be taken back.
  double longest() const
  {
    const TrialOutcome& now = this->Set.outcome;
    return this->met(now) ? std::min(now.cutLength(), this->Longest) : this->Longest;
  }

  bool met(const TrialOutcome& outcome) const { return outcome.strainP95 <= this->Search.bound; }

  /// A logarithm; what is less is better.
  double merit(const TrialOutcome& outcome) const
  {
    if (this->Search.bound == 0.0)
    {
      return std::log(distortionOf(outcome));
    }
    const double price = outcome.cutLength() / this->Size +
      this->Search.fixedPrice * static_cast<double>(outcome.lengths.size());
    // A quantile alone says little of where a small move leads.
    const double strain =
      std::sqrt(outcome.strainP95 * this->QuantileOverMean * std::sqrt(outcome.energy));
    return std::log(price) +
      (this->met(outcome) ? 1.0 : unmetWeight) * std::log(strain / this->Search.bound);
  }

  /// \param quick of a trial in which no cuts were closed
  bool better(TrialOutcome outcome, bool quick) const
  {
    const TrialOutcome& now = this->Set.outcome;
    if (quick && this->Subject.flattening.closeCuts)
    {
      outcome.overlaps = 0;
      outcome.severity = 0;
    }
    const double least = this->Search.leastLength * this->Size;
    const bool lengthy = std::all_of(outcome.lengths.begin() +
        static_cast<std::ptrdiff_t>(std::min(this->FirstCount, outcome.lengths.size())),
      outcome.lengths.end(), [&](double length) { return length >= least; });
    return outcome.soundAfter(now) && lengthy &&
      outcome.pieceStrains.size() == now.pieceStrains.size() &&
      outcome.leastPiece >= std::min(leastShareOff, now.leastPiece) &&
      outcome.cutLength() <= this->longest() && (this->met(outcome) || !this->met(now)) &&
      this->merit(outcome) < this->merit(now) - leastFall;
  }

  bool carriesOthers(std::size_t k) const
  {
    return isCarrier(this->Set.cuts, k, onPlace * this->Size);
  }

  bool paired(std::size_t k) const
  {
    return k + 1 < this->Set.cuts.size() && this->Set.cuts[k + 1].mirrorOf == static_cast<Index>(k);
  }

  /// The set with others in the place of a cut and its image, all darts cut back where that is too
  /// long. Empty where they are too short for that.
  std::vector<SuggestedCurve> with(std::size_t k, const std::vector<Polyline>& lines) const
  {
    std::vector<SuggestedCurve> cuts = this->Set.cuts;
    for (std::size_t j = 0; j < lines.size(); ++j)
    {
      cuts[k + j].curve.points = lines[j].points;
      cuts[k + j].length = lengthOf(lines[j].points);
    }
    double all = 0.0;
    double shortenable = 0.0;
    for (std::size_t j = 0; j < cuts.size(); ++j)
    {
      all += cuts[j].length;
      shortenable += this->Shortenable[j] ? cuts[j].length : 0.0;
    }
    const double excess = all - (1.0 - lengthToSpare) * this->longest();
    if (excess <= 0.0)
    {
      return cuts;
    }
    if (excess >= shortenable)
    {
      return {};
    }
    for (std::size_t j = 0; j < cuts.size(); ++j)
    {
      if (this->Shortenable[j])
      {
        cuts[j].length *= 1.0 - excess / shortenable;
        cuts[j].curve.points = shortened(cuts[j].curve.points, cuts[j].length);
      }
    }
    return cuts;
  }

  std::vector<Polyline> withImage(std::vector<Polyline> lines) const
  {
    return this->Twice ? withImages(std::move(lines), *this->Subject.mirror) : lines;
  }

  void findShortenable()
  {
    this->Shortenable.clear();
    for (std::size_t k = 0; k < this->Set.cuts.size(); ++k)
    {
      const SuggestedCurve& cut = this->Set.cuts[k];
      const std::size_t group = cut.mirrorOf == none ? k : cut.mirrorOf;
      this->Shortenable.push_back(
        k >= this->FirstCount && cut.curve.type == CurveType::Dart && !this->carriesOthers(group)
          ? 1
          : 0);
    }
  }

  bool move(std::size_t k, double step)
  {
    if (this->carriesOthers(k))
    {
      return false;
    }
    this->findShortenable();
    const std::vector<Polyline> others = linesOf(withShare(this->Set.cuts, k, 0.0));
    std::vector<Polyline> curves = this->Subject.curves;
    curves.insert(curves.end(), others.begin(), others.end());
    const ImprintedSurface surface =
      imprintCurves(this->Subject.mesh, curves, this->Subject.imprint);
    const CutSurface cut = cutSurface(surface.mesh, surface.curves);
    const std::vector<PieceSurface> pieces = pieceSurfaces(surface, cut, this->Subject.weights);
    const VertexMarks marks = markVertices(surface, this->Search);
    const Indices images = pieceImages(pieces, this->Subject.mirror, this->Size);
    const Points3& line = this->Set.cuts[k].curve.points;
    const Point3 middle = 0.5 * (line[(line.size() - 1) / 2] + line[(line.size() + 1) / 2]);
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      const PieceSurface& piece = pieces[p];
      if (SurfaceLocator(piece.mesh).closest(middle).distance < onPlace * this->Size)
      {
        this->Twice = this->paired(k) && images[p] != none;
        const std::unique_ptr<SearchedPiece> searched =
          searchedPiece(piece, marks, this->Subject.mirror);
        const std::optional<CutPlan> plan = searched
          ? plannedCut(
              *searched, this->Set.cuts[k], this->paired(k) && !this->Twice, onPlace * this->Size)
          : std::nullopt;
        return plan && this->moveOn(*searched, *plan, step, k, others);
      }
    }
    return false;
  }

  /// Moves on to the best of the plans beside one that is better.
  bool moveOn(const SearchedPiece& piece, const CutPlan& now, double step, std::size_t k,
    const std::vector<Polyline>& others)
  {
    std::vector<CutPlan> plans = movedPlans(piece, now, step);
    // Where length is what is short, turning darts cost more trials than it gave.
    const std::vector<CutPlan> slid = slidPlans(piece, now, step, this->Search.bound > 0.0);
    plans.insert(plans.end(), slid.begin(), slid.end());
    std::vector<std::vector<Polyline>> lines(plans.size());
    std::vector<std::vector<Polyline>> sets(plans.size());
    this->Run.parallelFor(static_cast<Index>(plans.size()), [&](Index begin, Index end) {
      for (Index p = begin; p < end; ++p)
      {
        lines[p] = this->withImage(piece.polylines(plans[p]));
        if (lines[p].size() == (this->paired(k) ? 2U : 1U))
        {
          sets[p] = linesOf(this->with(k, lines[p]));
          sets[p].erase(sets[p].begin(),
            sets[p].begin() + std::min<std::ptrdiff_t>(this->FirstCount, sets[p].size()));
        }
      }
    });
    std::vector<TrialOutcome> outcomes = this->Quick.runAll(sets, this->Budget, this->Run);
    for (TrialOutcome& outcome : outcomes)
    {
      const std::vector<double>& all = this->Set.outcome.lengths;
      outcome.lengths.insert(outcome.lengths.begin(), all.begin(),
        all.begin() + static_cast<std::ptrdiff_t>(this->FirstCount));
    }
    std::vector<std::size_t> best;
    for (std::size_t p = 0; p < plans.size(); ++p)
    {
      if (!sets[p].empty() && this->better(outcomes[p], true))
      {
        best.push_back(p);
      }
    }
    std::stable_sort(best.begin(), best.end(), [&](std::size_t a, std::size_t b) {
      return this->merit(outcomes[a]) < this->merit(outcomes[b]);
    });
    best.resize(std::min(best.size(), this->Subject.flattening.closeCuts ? mostClosed : 1U));
    return std::any_of(best.begin(), best.end(),
      [&](std::size_t p) { return this->accept(piece, plans[p], k, lines[p], others); });
  }

  bool accept(const SearchedPiece& piece, const CutPlan& plan, std::size_t k,
    const std::vector<Polyline>& lines, const std::vector<Polyline>& others)
  {
    const std::vector<Polyline> own(lines.begin(), lines.end() - (this->Twice ? 1 : 0));
    const std::vector<Polyline> settled =
      this->withImage(settledCuts(this->Trials, others, own, piece));
    if (settled.size() != lines.size())
    {
      return false;
    }
    std::vector<SuggestedCurve> cuts = this->with(k, settled);
    if (cuts.empty())
    {
      return false;
    }
    cuts[k].via = plan.via;
    TrialOutcome after = this->Trials.run(linesOf(cuts), this->Budget, this->Run);
    if (!this->better(after, false))
    {
      return false;
    }
    this->Set.cuts = std::move(cuts);
    this->Set.outcome = std::move(after);
    this->takeLengths();
    return true;
  }

  const SearchSubject& Subject;
  const SearchOptions& Search;
  const Execution& Run;
  CutTrials Trials;
  CutTrials Quick; ///< the cuts that stay are curves of it
  TrialBudget& Budget;
  std::size_t FirstCount;
  double Size = 0.0;
  double QuantileOverMean = 1.0; ///< of the strain, at first
  CutSet& Set;
  double Longest;
  double LeftToThin;             ///< of the budget
  std::vector<char> Shortenable; ///< by cut
  bool Twice = false;            ///< the cut that moves has its image on another piece
};
}

void adjustCuts(const SearchSubject& subject, std::size_t firstCount, CutSet& set,
  TrialBudget& budget, const Execution& execution)
{
  if (set.outcome.valid && set.cuts.size() > firstCount)
  {
    Adjusting(subject, firstCount, set, budget, execution).run();
  }
}
}
