// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutSetSearch.h"

#include "Imprint/CurveImprint.h"
#include "Suggestion/CutThinning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace flattening
{
namespace
{
/// A cut whose price is sqrt(area / pi) has to lower the goal by this share to be worth it, and one
/// that is looked for anew by as much to be moved.
constexpr double minShare = 0.01;
/// Where a surface had to be cut open, a piece with more strain than this is divided by seams
/// before it is shaped by darts.
constexpr double dividedStrain = 0.1;
/// All cuts are looked for anew this often at most: more gave nothing on a hemisphere.
constexpr int maxRefits = 3;
/// A price, in sqrt(area / pi), besides which the length matters little.
constexpr double gainAlone = 5.0;
/// A search is given up from this many cuts on, where the bound would take four times the most
/// cuts: later ones gain less than the first.
constexpr Index cutsToTellBy = 3;
/// What a flattening in which legs of darts fold on each other may take, by one in which they do
/// not: mostly it is twice as much.
constexpr double maxFolding = 4.0;
/// Where the run is cancelled, steps after which the flattening that says what the cuts do is given
/// up: two to four seconds of a processor at 10,000 triangles.
constexpr double lastSteps = 400.0;
/// As many of the cuts found are tried on the surface itself, where the coarse version misled.
constexpr std::size_t maxAttempts = 4;
/// What the largest strain counts where sets miss the bound, beside the share of the area that
/// does.
constexpr double strainWeight = 0.1;
/// Up to this many cuts are searched for once.
constexpr Index singleSearch = 2;

/// The lines of a plan as they are proposed: by the points where they cross the surface's edges
/// beside some other cuts, the two of a pair exact images on a piece that is its own, and equally
/// long darts on another. Empty where they cannot be made.
std::vector<Polyline> settledCuts(const CutTrials& trials, const std::vector<Polyline>& others,
  const std::vector<Polyline>& lines, const SearchedPiece& piece)
{
  const std::vector<Points3> paths = trials.paths(withLines(others, lines));
  if (paths.empty())
  {
    return {};
  }
  std::vector<Polyline> settled = lines;
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    settled[k].points = paths[others.size() + k];
  }
  if (settled.size() == 2 && settled[0].type == CurveType::Dart)
  {
    // Where the mirror is not exact, sewing is easier by a dart that stops short than by a pair
    // that differs.
    const double first = polylineLength(settled[0].points);
    const double second = polylineLength(settled[1].points);
    Points3& longer = settled[first > second ? 0 : 1].points;
    longer = shortened(longer, std::min(first, second));
  }
  if (settled.size() == 2 && piece.mirrorIsExact())
  {
    settled[1].points = piece.mirror()->mirrored(settled[0].points);
  }
  return settled;
}

/// Share of the area in pieces that do not keep a bound, those that fold or overlap twice, and a
/// little for the largest strain; infinite where there is no flattening.
double failingShare(const CutSet& set, double bound)
{
  const TrialOutcome& outcome = set.outcome;
  double share = outcome.valid ? strainWeight * outcome.strainP95 / (1.0 + outcome.strainP95)
                               : std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < outcome.pieceAreas.size(); ++p)
  {
    const double weight = outcome.pieceFaults[p] ? 2.0 : 1.0;
    share += outcome.keeps(p, bound) ? 0.0 : weight * outcome.pieceAreas[p];
  }
  return share;
}

class SetSearch
{
public:
  SetSearch(
    const SearchSubject& subject, CutSet first, TrialBudget& budget, const Execution& execution)
    : Subject(subject)
    , Search(subject.search)
    , Run(execution)
    , Whole(subject.mesh, subject.curves, subject.imprint, subject.flattening, subject.goal,
        subject.weights)
    , Budget(budget)
    , FirstCount(first.cuts.size())
    , First(first.outcome)
    , Area(subject.mesh.area())
    , Size(std::sqrt(this->Area / pi))
    , Result(std::move(first))
  {
  }

  CutSet run()
  {
    this->addCuts();
    if (!this->met() && this->Result.end != SearchEnd::GivenUp)
    {
      this->refit();
    }
    if (this->met())
    {
      this->Result.end = SearchEnd::BoundMet;
      if (this->FirstCount == 0)
      {
        thinCuts(this->Whole, this->Search.bound, minCutLength * this->Size, this->Result.cuts,
          this->now(), this->Budget, this->Run);
      }
    }
    if (this->Budget.spent() && this->Result.end != SearchEnd::BoundMet)
    {
      this->Result.end = SearchEnd::WorkUsedUp;
    }
    return std::move(this->Result);
  }

private:
  TrialOutcome& now() { return this->Result.outcome; }
  const TrialOutcome& now() const { return this->Result.outcome; }

  /// No strain is known of a surface that has no flattening yet.
  bool met() const { return this->now().keeps(this->Search.bound); }

  bool finished()
  {
    if (static_cast<Index>(this->Result.cuts.size()) >= this->Search.maximumCuts)
    {
      this->Result.end = SearchEnd::CutsUsedUp;
      return true;
    }
    return this->met() || this->Budget.spent() || this->Run.cancelled() || this->hopeless();
  }

  /// By what the cuts so far did; each of several pieces may need as many.
  bool hopeless()
  {
    const auto made = static_cast<Index>(this->Result.cuts.size() - this->FirstCount);
    if (this->Search.bound == 0.0 || made < cutsToTellBy || !this->First.valid)
    {
      return false;
    }
    // Of the strain, with which the goal goes.
    const double power = this->Subject.goal == SearchGoal::Strain ? 4.0
      : this->Subject.goal == SearchGoal::Energy                  ? 2.0
                                                                  : 1.0;
    const double done = std::log(this->First.goal / this->now().goal) / made;
    const double left = power * std::log(this->now().strainP95 / this->Search.bound);
    const double needed = done > 0.0 ? made + left / done : std::numeric_limits<double>::infinity();
    const double most = static_cast<double>(this->Search.maximumCuts) *
      static_cast<double>(this->First.pieceStrains.size());
    if (needed > farTooManyCuts * most)
    {
      this->Result.end = SearchEnd::GivenUp;
      this->Result.cutsNeeded = needed;
      return true;
    }
    return false;
  }

  void addCuts()
  {
    while (!this->finished() && this->addCut())
    {
    }
  }

  /// Looks for each cut anew, given all others, where it may now lie better or be shorter.
  void refit()
  {
    for (int pass = 0; this->groups() > 1 && pass < maxRefits; ++pass)
    {
      bool better = false;
      for (std::size_t k = this->FirstCount; k < this->Result.cuts.size(); ++k)
      {
        if (this->met() || this->Budget.spent() || this->Run.cancelled())
        {
          return;
        }
        better = (this->Result.cuts[k].mirrorOf == none && this->refitCut(k)) || better;
      }
      if (!better)
      {
        return;
      }
      this->addCuts(); // a pair may have become one cut
    }
  }

  /// Cuts, mirror images not counted.
  std::ptrdiff_t groups() const
  {
    return std::count_if(this->Result.cuts.begin(), this->Result.cuts.end(),
      [](const SuggestedCurve& cut) { return cut.mirrorOf == none; });
  }

  bool refitCut(std::size_t k)
  {
    const std::vector<SuggestedCurve> cuts = this->Result.cuts;
    const TrialOutcome now = this->now();
    this->Result.cuts = withShare(cuts, k, 0.0);
    this->now() = this->Whole.run(this->chosen(), this->Budget, this->Run);
    this->Refitting = true;
    const bool found = this->now().valid && this->addCut() && this->now().soundAfter(now) &&
      this->now().goal < (1.0 - minShare) * now.goal &&
      static_cast<Index>(this->Result.cuts.size()) <= this->Search.maximumCuts;
    this->Refitting = false;
    if (!found)
    {
      this->Result.cuts = cuts;
      this->now() = now;
    }
    return found;
  }

  std::vector<Polyline> chosen() const { return linesOf(this->Result.cuts); }

  double lengthLeft(const std::vector<SuggestedCurve>& cuts) const
  {
    double left = this->Search.cutLengthLimit();
    for (const SuggestedCurve& cut : cuts)
    {
      left -= cut.length;
    }
    return left;
  }

  /// One round. False where no piece has a cut that is worth it.
  bool addCut()
  {
    const ImprintedSurface surface = imprintCurves(
      this->Subject.mesh, withLines(this->Subject.curves, this->chosen()), this->Subject.imprint);
    const CutSurface cut = cutSurface(surface.mesh, surface.curves);
    const std::vector<PieceSurface> pieces = pieceSurfaces(surface, cut, this->Subject.weights);
    const VertexMarks marks = markVertices(surface, this->Search);
    const bool known = this->now().pieceStrains.size() == pieces.size();
    std::vector<std::size_t> order;
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      if (!known || !this->now().keeps(p, this->Search.bound))
      {
        order.push_back(p);
      }
    }
    if (known)
    {
      std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
        return this->now().pieceGoals[a] > this->now().pieceGoals[b];
      });
    }
    const Indices images = pieceImages(pieces, this->Subject.mirror, this->Size);
    std::vector<char> done(pieces.size(), 0);
    return std::any_of(order.begin(), order.end(), [&](std::size_t p) {
      const bool twice = images[p] != none && images[p] != static_cast<Index>(p);
      if (twice && (done[images[p]] || this->cutsLeft() < 2))
      {
        return false;
      }
      done[p] = 1;
      return this->cutPiece(pieces[p], marks, known ? this->now().pieceStrains[p] : 0.0, twice);
    });
  }

  /// A pair of mirror images counts as two.
  Index cutsLeft() const
  {
    return this->Search.maximumCuts - static_cast<Index>(this->Result.cuts.size());
  }

  /// \param twice a piece that is its image is cut alike
  bool cutPiece(const PieceSurface& piece, const VertexMarks& marks, double strain, bool twice)
  {
    const double copies = twice ? 2.0 : 1.0;
    SearchOptions search = this->Search;
    if (search.cuts == SuggestedCuts::All && this->FirstCount > 0 && strain > dividedStrain)
    {
      search.cuts = SuggestedCuts::Seams;
    }
    search.maximumCuts = this->cutsLeft() / (twice ? 2 : 1);
    if (this->Refitting)
    {
      search.fixedPrice = gainAlone;
    }
    PieceSearch found(piece, marks, this->Subject, search);
    if (!found.ok(this->Run))
    {
      return false;
    }
    const std::vector<TriedCut> best =
      found.run(this->lengthLeft(this->Result.cuts) / copies, this->Budget, this->Run);
    for (std::size_t k = 0; k < std::min(best.size(), maxAttempts) && this->worthIt(best[k]); ++k)
    {
      if (this->accept(best[k], found, twice))
      {
        return true;
      }
    }
    return false;
  }

  bool worthIt(const TriedCut& cut) const
  {
    const double share = this->now().valid ? cut.score / this->now().goal : 1.0;
    return share * this->Size >= minShare;
  }

  bool accept(const TriedCut& best, PieceSearch& piece, bool twice)
  {
    const std::vector<Polyline> lines = piece.lines(best.plan);
    if (lines.empty())
    {
      return false;
    }
    std::vector<SuggestedCurve> cuts = this->Result.cuts;
    const std::size_t first = cuts.size();
    std::vector<Polyline> settled = settledCuts(this->Whole, this->chosen(), lines, piece.fine());
    settled = twice ? withImages(std::move(settled), *this->Subject.mirror) : settled;
    for (std::size_t k = 0; k < settled.size(); ++k)
    {
      SuggestedCurve cut;
      cut.curve = settled[k];
      cut.predictedGain = best.plan.predictedGain / this->Area;
      cut.opening = best.plan.opening;
      cut.mirrorOf = k > 0 ? static_cast<Index>(first) : none;
      cuts.push_back(std::move(cut));
    }
    TrialOutcome after = this->Whole.run(linesOf(cuts), this->Budget, this->Run);
    if (settled.empty() || !after.valid ||
      (this->now().valid && (!after.soundAfter(this->now()) || after.goal >= this->now().goal)))
    {
      return false;
    }
    for (std::size_t k = 0; k < cuts.size(); ++k)
    {
      cuts[k].length = after.lengths[k];
    }
    if (this->lengthLeft(cuts) < 0.0)
    {
      return false;
    }
    this->Result.cuts = std::move(cuts);
    this->now() = std::move(after);
    previewCuts(this->Result.cuts, this->Run);
    return true;
  }

  const SearchSubject& Subject;
  const SearchOptions& Search;
  const Execution& Run;
  CutTrials Whole;
  TrialBudget& Budget;
  std::size_t FirstCount;
  TrialOutcome First; ///< of the cuts that there are whatever the bound
  double Area;
  double Size; ///< sqrt(area / pi)
  bool Refitting = false;
  CutSet Result;
};

/// Makes seams of darts in pieces that miss the bound. False where there are none.
bool openFolds(
  const CutTrials::Trial& flat, std::size_t curves, double bound, std::vector<SuggestedCurve>& cuts)
{
  bool opened = false;
  const CutSurface& cut = *flat.flat.cut;
  for (Index h = 0; h < cut.mesh.halfedgeCount(); ++h)
  {
    const Index piece = cut.pieceOfTriangle[h / 3];
    const Index curve = cut.curveOfHalfedge[h] - static_cast<Index>(curves);
    if (curve >= 0 && cuts[curve].curve.type == CurveType::Dart &&
      !flat.outcome.keeps(piece, bound))
    {
      cuts[curve].curve.type = CurveType::Seam;
      opened = true;
    }
  }
  pairTypes(cuts);
  return opened;
}
}

std::vector<SearchStrategy> searchStrategies(const SearchOptions& options)
{
  std::vector<SearchStrategy> all;
  for (SuggestedCuts cuts : { SuggestedCuts::All, SuggestedCuts::Darts, SuggestedCuts::Seams })
  {
    if (cuts == options.cuts || options.cuts == SuggestedCuts::All)
    {
      all.push_back({ cuts, SearchGoal::Energy });
      all.push_back({ cuts, options.bound > 0.0 ? SearchGoal::Strain : SearchGoal::Area });
    }
  }
  const bool few = options.maximumCuts > 0 && options.maximumCuts <= singleSearch;
  all.resize(few ? 1 : all.size());
  return all;
}

bool keepsLimits(const CutSet& set, const SearchOptions& wanted)
{
  const double length = std::accumulate(set.cuts.begin(), set.cuts.end(), 0.0,
    [](double sum, const SuggestedCurve& cut) { return sum + cut.length; });
  const auto count = static_cast<Index>(set.cuts.size());
  return (wanted.maximumCuts == 0 || count <= wanted.maximumCuts) &&
    length <= wanted.cutLengthLimit();
}

Index excessPieces(const CutSet& set, const SearchOptions& wanted)
{
  const auto found = static_cast<Index>(set.outcome.pieceStrains.size());
  return wanted.pieces > 0 ? std::max<Index>(0, found - wanted.pieces) : 0;
}

bool isBetter(const CutSet& a, const CutSet& b, const SearchOptions& wanted, double area)
{
  const auto merit = [&wanted, area](const CutSet& set) {
    const TrialOutcome& outcome = set.outcome;
    if (!outcome.valid)
    {
      return std::tuple(3, Index(0), set.cuts.empty() ? 1.0 : 0.0);
    }
    const Index excess = excessPieces(set, wanted);
    if (wanted.bound == 0.0)
    {
      return std::tuple(0, excess, std::cbrt(outcome.energy * std::pow(outcome.areaError, 4.0)));
    }
    const double waste = wanted.pieces > 0 ? 0.0 : wastePrice * outcome.waste / area;
    const double price = waste + priceOf(set.cuts, std::sqrt(area / pi));
    return outcome.keeps(wanted.bound)
      ? std::tuple(0, excess, price)
      : std::tuple(outcome.faults() > 0 ? 2 : 1, excess,
          static_cast<double>(outcome.faults()) + outcome.strainP95);
  };
  return merit(a) < merit(b);
}

const CutSet& bestOf(const std::vector<CutSet>& sets, const SearchOptions& wanted, double area)
{
  return *std::min_element(sets.begin(), sets.end(),
    [&](const CutSet& a, const CutSet& b) { return isBetter(a, b, wanted, area); });
}

const CutSet& leastFailing(
  const std::vector<CutSet>& sets, const SearchOptions& wanted, double area)
{
  const CutSet& best = bestOf(sets, wanted, area);
  const double bound = missedBy * wanted.bound;
  if (bound == 0.0 || wanted.pieces > 0 || best.outcome.keeps(bound))
  {
    return best;
  }
  const CutSet& least =
    *std::min_element(sets.begin(), sets.end(), [bound](const CutSet& a, const CutSet& b) {
      return failingShare(a, bound) < failingShare(b, bound);
    });
  return failingShare(least, bound) < failingShare(best, bound) ? least : best;
}

CutSet searchCuts(
  const SearchSubject& subject, CutSet first, TrialBudget& budget, const Execution& execution)
{
  return SetSearch(subject, std::move(first), budget, execution).run();
}

CutSet withFolds(CutSet set, const CutTrials& trials, std::size_t curves, double bound,
  TrialBudget& budget, const Execution& execution)
{
  CutSet open = set;
  const auto isDart = [](const SuggestedCurve& cut) { return cut.curve.type == CurveType::Dart; };
  for (SuggestedCurve& cut : open.cuts)
  {
    cut.curve.type = CurveType::Seam;
  }
  CutTrials::Trial flat = trials.trial(linesOf(open.cuts), budget, execution);
  if (execution.cancelled() && !flat.outcome.valid)
  {
    TrialBudget some(std::min(budget.left(), trials.workOf(lastSteps)), budget);
    flat = trials.trial(linesOf(open.cuts), some, execution.uninterrupted());
  }
  open.outcome = std::move(flat.outcome);
  if (!trials.foldsDarts())
  {
    set.outcome = open.outcome;
    return set;
  }
  const double most = maxFolding * flat.work;
  while (open.outcome.valid && std::any_of(set.cuts.begin(), set.cuts.end(), isDart))
  {
    TrialBudget folding(std::min(most, budget.left()), budget);
    flat = trials.trial(linesOf(set.cuts), folding, execution);
    if (!flat.outcome.valid)
    {
      break;
    }
    set.outcome = flat.outcome;
    if (!openFolds(flat, curves, bound, set.cuts))
    {
      return set;
    }
  }
  return open;
}

void measureCuts(const CutTrials& trials, const TrialOutcome& without, const TrialOutcome& with,
  double area, std::vector<SuggestedCurve>& cuts, TrialBudget& budget, const Execution& execution)
{
  // After each cut or pair but the last, which is known.
  std::vector<std::size_t> ends;
  std::vector<std::vector<Polyline>> lines;
  for (std::size_t k = 0; k < cuts.size(); ++k)
  {
    if (k + 1 == cuts.size() || cuts[k + 1].mirrorOf == none)
    {
      ends.push_back(k + 1);
      lines.push_back(linesOf({ cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(k + 1) }));
    }
  }
  if (!lines.empty())
  {
    lines.back().clear();
  }
  if (static_cast<Index>(lines.size()) > maxMeasuredCuts)
  {
    lines.assign(lines.size(), {});
  }
  const std::vector<TrialOutcome> after = trials.runAll(lines, budget, execution);
  TrialOutcome before = without;
  std::size_t begin = 0;
  for (std::size_t e = 0; e < ends.size(); ++e)
  {
    const TrialOutcome& now = e + 1 == ends.size() ? with : after[e];
    for (std::size_t j = begin; j < ends[e]; ++j)
    {
      cuts[j].areaErrorBefore = before.valueOrNaN(before.areaError);
      cuts[j].areaErrorAfter = now.valueOrNaN(now.areaError);
      cuts[j].strainBefore = before.valueOrNaN(before.strainP95);
      cuts[j].strainAfter = now.valueOrNaN(now.strainP95);
      cuts[j].gain = (before.valueOrNaN(before.energy) - now.valueOrNaN(now.energy)) / area;
    }
    begin = ends[e];
    before = now;
  }
}
}
