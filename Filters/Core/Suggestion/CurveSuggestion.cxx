// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CurveSuggestion.h"

#include "Base/Memory.h"
#include "Cut/PieceTopology.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/ChartCuts.h"
#include "Suggestion/CutSetSearch.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/GoreSeams.h"
#include "Suggestion/OpeningCuts.h"
#include "Suggestion/SeamDrawing.h"
#include "Suggestion/SeamSettling.h"
#include "Suggestion/SideSeams.h"
#include "Suggestion/SmallPieces.h"
#include "Suggestion/StripSeams.h"
#include "Suggestion/SurfaceCoarsening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace flattening
{
namespace
{
/// Share of the remaining work for a search, and for parting the surface into charts.
constexpr double shareOfSearch = 0.5;
constexpr double shareOfCharts = 0.8;
/// Share of the work for the search on fewer triangles; a flattening of the surface itself takes
/// more of what is left the larger it is.
constexpr double shareOfCoarse = 0.7;
/// Share of all work for the surface without cuts: what takes more lies very badly.
constexpr double shareOfUncut = 0.2;
/// Share of the remaining work for gores where other cuts may follow.
constexpr double shareOfGores = 0.2;
/// The same for cuts between a front and a back, by each of two goals.
constexpr double shareOfSides = 0.25;
/// Steps after which a flattening of what is uncut or only opened is given up, and one with side
/// seams: of 25 garments and shoes those that keep the bound took up to 40, with side seams and
/// cuts 142, hopeless ones 550 to 750. What the cuts of fewer triangles may take at least.
constexpr double openedSteps = 75.0;
constexpr double sideSteps = 400.0;
constexpr double movedSteps = 100.0;
/// Side seams with more strain than this many times the bound have no single cuts added: of 11
/// garments with up to 5.5 times seven keep the bound with some, of 13 with 14 times or more none.
constexpr double sideStrain = 8.0;
/// Where the surface had to be opened, which takes many cuts.
constexpr double shareOpened = 0.9;
/// Largest share of all work kept for measuring what each cut gains, by this many steps each.
constexpr double shareOfMeasuring = 0.3;
constexpr double stepsOfMeasuring = 40.0;
/// Of cuts that are added one by one. Where charts take no more, darts may cost less.
constexpr Index maxAdded = 8;
/// A surface with more strain than this many times the bound takes charts rather than single cuts.
constexpr double chartStrain = 4.0;
/// Noise is where charts leave more of the strain than this, and than the above times the bound.
constexpr double noiseShare = 0.5;
/// Where charts would take more cuts than may be, they are tried again with the bound times this,
/// so often.
constexpr double looserBound = 1.5;
constexpr int maxLooser = 6;

class Suggesting
{
public:
  Suggesting(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
    const SuggestionOptions& options, TrialBudget budget, const Execution& execution)
    : Mesh(mesh)
    , Curves(curves)
    , Options(options)
    , Run(execution)
    , Weights(relativeWeights(mesh, options.weights))
    , Whole(mesh, curves, options.imprint, options.flattening, SearchGoal::Energy, this->Weights)
    , Area(mesh.area())
    , Budget(std::move(budget))
  {
    this->Run.progress = nullptr; // flattenings tell nothing of how far the search is
  }

  CurveSuggestions run()
  {
    this->Surface = imprintCurves(this->Mesh, this->Curves, this->Options.imprint);
    if (!this->Surface.status.ok())
    {
      return refusal(this->Surface.status);
    }
    if (this->Options.search.pieces > 0 && this->hasKeys())
    {
      return refusal(
        "a number of pieces is asked for, and key curves, across which no seam may run, are there",
        "no number of pieces, or no key curve");
    }
    const Status mirror = findMirror(this->Mesh, this->Curves, this->Options.search, this->Weights,
      this->Run, this->Result.mirror);
    if (!mirror.ok())
    {
      return refusal(mirror);
    }
    CutSet best = this->coarseSet();
    this->Cut = cutSurface(this->Surface.mesh, this->Surface.curves);
    if (!this->Cut.status.ok())
    {
      return refusal(this->Cut.status);
    }
    this->Pieces = extractPieces(this->Cut);
    this->Marks = markVertices(this->Surface, this->Options.search);
    CutSet uncut;
    if (best.cuts.empty() || std::isfinite(this->Result.strainBefore))
    {
      uncut.outcome = this->within(openedSteps, {}, shareOfUncut);
    }
    if (best.cuts.empty() && !this->Run.cancelled())
    {
      this->MostMeasuring = std::min(shareOfMeasuring * this->Budget.left(),
        stepsOfMeasuring * this->Mesh.triangleCount() * maxMeasuredCuts);
      best = this->narrowSet(uncut);
    }
    if (this->Run.cancelled() && !best.outcome.valid && best.cuts.empty())
    {
      return refusal({ StatusCode::Cancelled, "cancelled before any cut was chosen" });
    }
    const Index most = this->Options.search.maximumCuts;
    const bool unopened = !best.outcome.valid && most > 0 && !this->Run.cancelled();
    const std::size_t needed = unopened ? this->neededCuts().size() : 0;
    if (static_cast<Index>(needed) > most)
    {
      return refusal("the greatest number of cuts is " + std::to_string(most) +
          ", and to open the surface takes " + std::to_string(needed) + " seams",
        "a number from " + std::to_string(needed));
    }
    if (this->Options.search.cuts == SuggestedCuts::Gores && best.cuts.empty() &&
      !this->isFlat(best))
    {
      return refusal(this->Curves.empty()
          ? "half planes through no axis of the surface part it into gores"
          : "gores are of surfaces without other curves",
        "another kind of cuts");
    }
    this->Result.curves = best.cuts;
    if (!arePaired(best.cuts))
    {
      this->Result.mirror.reset();
    }
    nameCuts(this->Curves, this->Result.curves);
    measureCuts(this->Whole, uncut.outcome, best.outcome, this->Area, this->Result.curves,
      this->Budget, this->Run);
    const TrialOutcome& before = uncut.outcome;
    const TrialOutcome& after = best.outcome;
    this->Result.strainBefore = before.valueOrNaN(before.strainP95);
    this->Result.strainAfter = after.valueOrNaN(after.strainP95);
    this->Result.rigidEnergyBefore = before.valueOrNaN(before.energy / this->Area);
    this->Result.rigidEnergyAfter = after.valueOrNaN(after.energy / this->Area);
    const double widest = this->Options.search.maximumWidth;
    this->Result.boundMet = this->isFlat(best) && (widest == 0.0 || this->Result.width <= widest);
    this->Result.worstPlace = best.outcome.worstPlace;
    this->Result.trials = this->Budget.trials();
    this->Result.work = 1e-6 * this->Budget.work();
    return std::move(this->Result);
  }

private:
  static CurveSuggestions refusal(Status status)
  {
    CurveSuggestions refused;
    refused.status = std::move(status);
    return refused;
  }
  static CurveSuggestions refusal(const std::string& defect, const std::string& wanted)
  {
    return refusal(invalidOption(defect, wanted));
  }

  bool better(const CutSet& a, const CutSet& b) const
  {
    return isBetter(a, b, this->Options.search, this->Area);
  }

  TrialOutcome within(double steps, const std::vector<SuggestedCurve>& cuts, double share = 1.0)
  {
    TrialBudget some(
      std::min(this->Whole.workOf(steps), share * this->Budget.left()), this->Budget);
    return this->Whole.run(linesOf(cuts), some, this->Run);
  }

  SearchSubject subject(const SearchOptions& search, SearchGoal goal = SearchGoal::Energy) const
  {
    return { this->Mesh, this->Curves, this->Options.imprint, this->Options.flattening, search,
      this->Result.mirror, this->Weights, goal };
  }

  bool hasKeys() const
  {
    return std::any_of(this->Curves.begin(), this->Curves.end(),
      [](const Polyline& curve) { return curve.type == CurveType::Key; });
  }

  bool isFlat(const CutSet& set) const { return set.outcome.keeps(this->Options.search.bound); }

  /// On a large surface without curves, weights and exact mirror, the cuts of a version with
  /// fewer triangles, with what it takes to keep the bound. No cuts where none are found so.
  CutSet coarseSet()
  {
    const SearchOptions& wanted = this->Options.search;
    const std::optional<SurfaceMirror> given = this->Result.mirror;
    // Gores take few trials; few triangles do not mirror each other exactly.
    const bool exact = given && given->plane() && given->error <= SurfaceMirror::exact;
    CutSet set;
    const std::optional<TriangleMesh> few = !this->Curves.empty() || exact ||
        !this->Weights.empty() || wanted.cuts == SuggestedCuts::Gores
      ? std::nullopt
      : coarseVersion(this->Mesh);
    if (!few)
    {
      return set;
    }
    TrialBudget searching(shareOfCoarse * this->Budget.left(), this->Budget);
    CurveSuggestions found =
      Suggesting(*few, this->Curves, this->Options, std::move(searching), this->Run).run();
    this->Result.strainBefore = found.strainBefore;
    this->Result.mirror = std::move(found.mirror);
    set.cuts = movedCuts(this->Mesh, this->Result.mirror, std::move(found.curves));
    if (wanted.bound > 0.0)
    {
      TrialBudget budget(shareOfSearch * this->Budget.left(), this->Budget);
      set.cuts = partedCharts(this->Mesh, this->Result.mirror, this->chartOptions(wanted.bound),
        wanted.bound, std::move(set.cuts), budget, this->Run);
    }
    if (!set.cuts.empty())
    {
      TrialBudget budget(
        std::max(this->Budget.left(), this->Whole.workOf(movedSteps)), this->Budget);
      set = withFolds(std::move(set), this->Whole, 0, wanted.bound, budget, this->Run);
    }
    if (set.cuts.empty() || !keepsLimits(set, wanted))
    {
      this->Result.mirror = given;
      return {};
    }
    this->Result.end = this->Run.cancelled() ? SearchEnd::Interrupted
      : this->isFlat(set)                    ? SearchEnd::BoundMet
      : this->Budget.spent()                 ? SearchEnd::WorkUsedUp
                                             : found.end;
    this->Result.cutsNeeded = found.cutsNeeded;
    set = this->joined(std::move(set));
    return wanted.maximumWidth > 0.0 ? this->withStrips(std::move(set)) : set;
  }

  /// The best set whose pieces are no wider than allowed: strips of the uncut surface, as of a
  /// sail, where cuts in these meet the bound; otherwise the best set in strips.
  CutSet narrowSet(const CutSet& uncut)
  {
    const SearchOptions& wanted = this->Options.search;
    const bool limited = wanted.maximumWidth > 0.0;
    if (limited && wanted.cuts != SuggestedCuts::Gores && uncut.outcome.valid &&
      wanted.pieces == 0 && wanted.cuts != SuggestedCuts::Darts &&
      uncut.outcome.strainP95 <= chartStrain * wanted.bound)
    {
      CutSet strips = this->withStrips(uncut);
      strips = strips.cuts.empty() ? strips : this->improved(std::move(strips));
      if (this->isFlat(strips))
      {
        this->Result.end = SearchEnd::BoundMet;
        return strips;
      }
    }
    CutSet best = this->bestSet(uncut);
    return limited ? this->withStrips(std::move(best)) : best;
  }

  /// Pieces that are too wide are parted into strips.
  CutSet withStrips(CutSet set)
  {
    return inStrips(std::move(set), this->subject(this->Options.search), this->Budget, this->Run,
      this->Result.width);
  }

  /// The best set that is found, which is never worse than no cuts.
  CutSet bestSet(const CutSet& uncut)
  {
    const SearchOptions& wanted = this->Options.search;
    if (this->isFlat(uncut) &&
      wanted.pieces <= static_cast<Index>(uncut.outcome.pieceStrains.size()))
    {
      this->Result.end = SearchEnd::BoundMet;
      return uncut;
    }
    if (wanted.cuts == SuggestedCuts::Gores)
    {
      return this->goreSet();
    }
    const bool strained = wanted.pieces > 0 || !uncut.outcome.valid ||
      uncut.outcome.strainP95 > chartStrain * wanted.bound;
    bool creased = false;
    for (Index h = 0; h < this->Surface.mesh.halfedgeCount(); ++h)
    {
      creased = creased || isCrease(this->Surface.mesh, h);
    }
    const std::optional<SurfaceMirror>& mirror = this->Result.mirror;
    const bool round = strained && this->Curves.empty() && wanted.bound > 0.0 &&
      wanted.cuts != SuggestedCuts::Darts && mirror && mirror->plane();
    TrialBudget trying(
      (wanted.pieces > 0 ? 1.0 : shareOfGores) * this->Budget.left(), this->Budget);
    Gores gores = round
      ? findGores(this->Mesh, *mirror->plane(), this->Whole, wanted, trying, this->Run)
      : Gores();
    const bool flat = this->isFlat(gores.set);
    const bool usable = gores.set.outcome.valid && keepsLimits(gores.set, this->Options.search) &&
      (flat || wanted.pieces > 0 || wanted.maximumCuts > 0);
    // One piece with a free boundary may open along a tree, within the bound.
    const bool opens =
      wanted.pieces == 1 && this->Options.flattening.boundary == BoundaryMode::Free;
    // Charts of a smooth round surface are strips that wind round it, with less seam and worse to
    // sew.
    const bool alone = !creased && excessPieces(gores.set, wanted) == 0 &&
      (flat || (gores.equal && usable && wanted.pieces > 0 && !opens));
    this->Result.end = SearchEnd::NothingHelps;
    CutSet set = alone ? gores.set : this->searchedSet(uncut, strained, creased);
    if (alone || (usable && !this->better(set, gores.set)))
    {
      this->Result.end = flat ? SearchEnd::BoundMet : this->Result.end;
      this->Result.mirror = SurfaceMirror(gores.plane);
      return std::move(gores.set);
    }
    return set;
  }

  /// Gores, whatever other cuts would do. No cuts where there are none.
  CutSet goreSet()
  {
    const std::optional<SurfaceMirror>& mirror = this->Result.mirror;
    const std::optional<SymmetryPlane> plane =
      mirror && mirror->plane() ? std::optional(*mirror->plane()) : findSymmetryPlane(this->Mesh);
    Gores gores = plane && this->Curves.empty()
      ? findGores(this->Mesh, *plane, this->Whole, this->Options.search, this->Budget, this->Run)
      : Gores();
    this->Result.end = this->isFlat(gores.set) ? SearchEnd::BoundMet : SearchEnd::NothingHelps;
    this->Result.mirror = SurfaceMirror(gores.plane);
    return keepsLimits(gores.set, this->Options.search) ? std::move(gores.set) : CutSet();
  }

  /// The best of charts and of cuts one by one.
  CutSet searchedSet(const CutSet& uncut, bool strained, bool creased)
  {
    const SearchOptions& wanted = this->Options.search;
    const bool charts = !this->hasKeys() &&
      (wanted.pieces > 0 || !uncut.outcome.valid ||
        (wanted.bound > 0.0 && wanted.cuts != SuggestedCuts::Darts));
    // Single cuts lower strains, and do not part what lies over itself.
    const bool parting = uncut.outcome.valid && uncut.outcome.strainP95 <= wanted.bound;
    const bool chartsFirst = strained || creased || parting;
    std::vector<CutSet> found;
    const bool tailored =
      charts && strained && wanted.pieces == 0 && wanted.bound > 0.0 && this->Curves.empty();
    CutSet sides = tailored ? this->sideSet() : CutSet();
    if (this->isFlat(sides))
    {
      this->Result.end = SearchEnd::BoundMet;
      return sides;
    }
    sides = this->parted(std::move(sides));
    // Where the run is cancelled, the first charts are better than what cannot be laid flat.
    if (charts && chartsFirst && !(uncut.outcome.valid && this->Run.cancelled()))
    {
      found.push_back(this->chartSet(uncut));
    }
    const bool few = uncut.outcome.valid && !parting && !found.empty() &&
      static_cast<Index>(found.front().cuts.size()) <= maxAdded;
    // Other cuts do not come in pairs, unless the mirror is exact.
    const bool paired = wanted.symmetric != "on" && !found.empty() &&
      found.front().outcome.faults() == 0 && arePaired(found.front().cuts);
    if (found.empty() || (wanted.pieces == 0 && !paired && (few || !this->isFlat(found.front()))))
    {
      this->addSets(found, this->neededCuts());
    }
    if (!sides.cuts.empty() && sides.outcome.overlaps == 0)
    {
      found.push_back(this->joined(std::move(sides)));
    }
    if (charts && !chartsFirst && found.front().end != SearchEnd::GivenUp &&
      std::none_of(
        found.begin(), found.end(), [this](const CutSet& set) { return this->isFlat(set); }))
    {
      found.push_back(this->chartSet(uncut));
    }
    if (found.empty())
    {
      this->Result.end = this->Run.cancelled() ? SearchEnd::Interrupted : SearchEnd::CutsUsedUp;
      return uncut;
    }
    const CutSet& best = leastFailing(found, wanted, this->Area);
    const bool limited = std::any_of(found.begin(), found.end(),
      [](const CutSet& one) { return one.end == SearchEnd::WorkUsedUp; });
    const bool givenUp = found.front().end == SearchEnd::GivenUp && !this->isFlat(best);
    this->Result.end = this->Run.cancelled() ? SearchEnd::Interrupted
      : givenUp                              ? SearchEnd::GivenUp
      : limited && !this->isFlat(best)       ? SearchEnd::WorkUsedUp
                                             : best.end;
    this->Result.cutsNeeded = givenUp ? found.front().cutsNeeded : best.cutsNeeded;
    const TrialOutcome& with = best.outcome;
    const bool worse = wanted.bound > 0.0
      ? !this->isFlat(best) && with.strainP95 > uncut.outcome.strainP95
      : with.energy > uncut.outcome.energy;
    return uncut.outcome.valid && (worse || !with.valid) ? uncut : best;
  }

  /// Seams between a front and a back of each part, as a tailor lays them, with single cuts in what
  /// they part. Where the seams that open the surface are enough, these. No cuts where no part has
  /// two openings.
  CutSet sideSet()
  {
    CutSet set;
    bool sides = false;
    for (const Piece& piece : this->Pieces)
    {
      std::vector<SuggestedCurve> seams =
        sideSeams(piece.mesh, this->Pieces.size() == 1 ? this->Result.mirror : std::nullopt);
      sides = sides || !seams.empty();
      seams = seams.empty() ? this->opened(piece) : std::move(seams);
      set.cuts.insert(set.cuts.end(), seams.begin(), seams.end());
    }
    if (!sides)
    {
      return {};
    }
    CutSet opened;
    opened.cuts = this->neededCuts();
    opened.outcome = this->within(openedSteps, opened.cuts);
    if (this->isFlat(opened) && keepsLimits(opened, this->Options.search))
    {
      return opened;
    }
    set.outcome = this->within(sideSteps, set.cuts);
    if (!set.outcome.valid || set.outcome.flipped > 0 || !keepsLimits(set, this->Options.search))
    {
      return {};
    }
    const CutSet seams = set;
    const bool far = set.outcome.strainP95 > sideStrain * this->Options.search.bound;
    for (SearchGoal goal : { SearchGoal::Energy, SearchGoal::Strain })
    {
      if (!this->isFlat(set) && !far)
      {
        CutSet found = this->improved(seams, goal, shareOfSides);
        set = this->better(found, set) ? std::move(found) : set;
      }
    }
    return set;
  }

  /// Charts in all pieces that do not keep the bound, and what it takes to keep it beside them.
  CutSet chartSet(const CutSet& uncut)
  {
    const SearchOptions& wanted = this->Options.search;
    CutSet set;
    bool spent = false;
    double bound = wanted.bound > 0.0 ? wanted.bound : SearchOptions().bound;
    const double most = wanted.maximumCuts > 0
      ? farTooManyCuts * static_cast<double>(wanted.maximumCuts)
      : maxChartCuts * this->Cut.pieceCount;
    const double noise = uncut.outcome.valid ? noiseShare * uncut.outcome.strainP95 : 1.0;
    CutSet many; // those found at first, where they are more than that
    bool tooMany = false;
    for (int k = 0; k < maxLooser; ++k)
    {
      TrialBudget budget(shareOfCharts * this->Budget.left(), this->Budget);
      set = {};
      set.cuts = this->chartsOf(uncut, bound, most, budget);
      if (this->Pieces.size() > 1)
      {
        // What is near on the whole surface need not be on a small part.
        set.cuts =
          laidTogether(this->Mesh, std::move(set.cuts), this->Curves, this->Options.imprint);
      }
      set.cutsNeeded = static_cast<double>(set.cuts.size());
      many.cutsNeeded = k == 0 ? set.cutsNeeded : many.cutsNeeded;
      spent = budget.spent();
      // The number of cuts falls with the root of the bound, as the width of strips grows.
      const double excess = set.cutsNeeded / most;
      const double looser = bound * std::max(looserBound, excess * excess);
      tooMany = tooMany || excess > 1.0;
      if (excess > 1.0 && (looser > noise || k + 1 == maxLooser))
      {
        if (!uncut.outcome.valid && many.outcome.valid)
        {
          break;
        }
        return { {}, {}, SearchEnd::GivenUp, many.cutsNeeded }; // as far from flat as without
      }
      if (excess <= 1.0)
      {
        set = withFolds(
          std::move(set), this->Whole, this->Curves.size(), bound, this->Budget, this->Run);
        if (!set.outcome.valid || keepsLimits(set, this->Options.search))
        {
          break;
        }
      }
      else if (k == 0 && wanted.maximumCuts == 0)
      {
        many = withFolds( // better than what lies over itself
          set, this->Whole, this->Curves.size(), bound, this->Budget, this->Run);
      }
      bound = looser;
    }
    if ((!set.outcome.valid || set.outcome.faults() > 0) && this->better(many, set))
    {
      set = many;
    }
    if (uncut.outcome.valid && wanted.bound > 0.0 &&
      set.outcome.strainP95 >
        std::max(chartStrain * wanted.bound, noiseShare * uncut.outcome.strainP95))
    {
      return { {}, {}, SearchEnd::GivenUp, many.cutsNeeded }; // noise is hardly nearer to flat
    }
    if (!set.outcome.valid || !keepsLimits(set, this->Options.search))
    {
      return { {}, {}, spent ? SearchEnd::WorkUsedUp : SearchEnd::CutsUsedUp, set.cutsNeeded };
    }
    set.end = this->isFlat(set) ? SearchEnd::BoundMet
      : tooMany                 ? SearchEnd::CutsUsedUp
                                : SearchEnd::NothingHelps;
    set.cutsNeeded = tooMany ? many.cutsNeeded : set.cutsNeeded;
    if (set.end == SearchEnd::NothingHelps && wanted.bound > 0.0 && wanted.pieces == 0)
    {
      if (set.outcome.faults() > 0)
      {
        set = this->parted(std::move(set)); // single cuts are hardly found there
      }
      set = this->parted(this->improved(std::move(set)));
    }
    return this->joined(std::move(set));
  }

  /// Without small pieces.
  CutSet joined(CutSet set)
  {
    return withoutSmallPieces(
      std::move(set), this->subject(this->Options.search), this->Whole, this->Budget, this->Run);
  }

  /// With charts that miss the bound parted, where others than single cuts help.
  CutSet parted(CutSet set)
  {
    if (this->isFlat(set) || !this->Curves.empty() || this->Run.cancelled())
    {
      return set;
    }
    TrialBudget budget(shareOfSearch * this->Budget.left(), this->Budget);
    const double bound = this->Options.search.bound;
    CutSet more;
    more.cuts = partedCharts(this->Mesh, this->Result.mirror, this->chartOptions(bound), bound,
      set.cuts, budget, this->Run);
    if (more.cuts.size() == set.cuts.size())
    {
      return set;
    }
    more = withFolds(std::move(more), this->Whole, 0, bound, this->Budget, this->Run);
    more.end = this->isFlat(more) ? SearchEnd::BoundMet : set.end;
    more.cutsNeeded = static_cast<double>(more.cuts.size());
    return keepsLimits(more, this->Options.search) && this->better(more, set) ? more : set;
  }

  /// With more cuts, one after the other, until the bound is met.
  /// \param share of the remaining work
  CutSet improved(CutSet set, SearchGoal goal = SearchGoal::Strain, double share = shareOfSearch)
  {
    if (this->isFlat(set) || this->Run.cancelled())
    {
      return set;
    }
    TrialBudget budget(share * this->Budget.left(), this->Budget);
    SearchOptions options = this->Options.search;
    const auto count = static_cast<Index>(set.cuts.size());
    options.maximumCuts =
      options.maximumCuts > 0 ? options.maximumCuts : count + std::max(maxAdded, count / 2);
    if (goal != SearchGoal::Energy) // which is that of the set's outcome
    {
      set.outcome = this->flattened(set.cuts, goal, budget);
    }
    return searchCuts(this->subject(options, goal), std::move(set), budget, this->Run);
  }

  ChartOptions chartOptions(double bound) const
  {
    ChartOptions options;
    options.bound = bound;
    options.mirrorKept = this->Options.search.symmetric != "on";
    options.pieces = this->Options.search.pieces;
    options.darts = this->Options.search.cuts == SuggestedCuts::All;
    options.flattening = this->Options.flattening;
    return options;
  }

  std::vector<SuggestedCurve> chartsOf(
    const CutSet& uncut, double bound, double most, TrialBudget& budget) const
  {
    ChartOptions options = this->chartOptions(bound);
    options.maxCuts = most;
    const std::vector<Piece>& pieces = this->Pieces;
    const bool known = uncut.outcome.pieceStrains.size() == pieces.size();
    const std::optional<SurfaceMirror>& mirror = this->Result.mirror;
    const Indices images = pieceImages(
      pieceSurfaces(this->Surface, this->Cut), mirror, std::sqrt(this->Area / pi), true);
    std::vector<char> done(pieces.size(), 0);
    double area = 0.0;
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      const bool kept = known && uncut.outcome.keeps(p, this->Options.search.bound);
      done[p] = options.pieces == 0 && kept ? 1 : 0;
      area += done[p] ? 0.0 : pieces[p].mesh.area();
    }
    const Index wanted =
      std::max<Index>(0, options.pieces - std::count(done.begin(), done.end(), 1));
    std::vector<SuggestedCurve> cuts;
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      if (done[p])
      {
        continue;
      }
      if (options.pieces > 0)
      {
        options.pieces = std::max<Index>(1, std::lround(wanted * pieces[p].mesh.area() / area));
      }
      const auto before = static_cast<Index>(cuts.size());
      // The rest of the work is for all pieces that follow.
      double triangles = 0.0;
      for (std::size_t q = p; q < pieces.size(); ++q)
      {
        triangles += done[q] ? 0.0 : pieces[q].mesh.triangleCount();
      }
      TrialBudget share(budget.left() * pieces[p].mesh.triangleCount() / triangles, budget);
      Execution run = this->Run;
      if (run.preview)
      {
        run.preview = [&](std::vector<Points3> lines) {
          for (const SuggestedCurve& cut : cuts)
          {
            lines.push_back(cut.curve.points);
          }
          this->Run.preview(lines);
        };
      }
      std::optional<SymmetryPlane> plane;
      if (mirror && mirror->plane() && (images[p] == static_cast<Index>(p) || pieces.size() == 1))
      {
        plane = measuredPlane(pieces[p].mesh, *mirror->plane());
      }
      std::vector<SuggestedCurve> here = chartCuts(pieces[p].mesh, plane, options, share, run);
      if (findDefect(pieces[p]) && !laysOpen(pieces[p].mesh, linesOf(here)))
      {
        here = this->opened(pieces[p]); // seams were left out that cannot be drawn apart
      }
      for (SuggestedCurve& one : here)
      {
        one.mirrorOf += one.mirrorOf == none ? 0 : before;
        cuts.push_back(std::move(one));
      }
      if (images[p] > static_cast<Index>(p))
      {
        done[images[p]] = addImages(
          cuts, before, *mirror, pieces[p].mesh, pieces[images[p]].mesh, options, share, this->Run);
      }
    }
    return cuts;
  }

  /// Cuts without which a piece cannot be laid flat at all.
  std::vector<SuggestedCurve> neededCuts() const
  {
    std::vector<SuggestedCurve> cuts;
    for (const Piece& piece : this->Pieces)
    {
      const std::vector<SuggestedCurve> here = this->opened(piece);
      cuts.insert(cuts.end(), here.begin(), here.end());
    }
    return cuts;
  }

  /// Cuts without which one piece cannot be laid flat.
  std::vector<SuggestedCurve> opened(const Piece& piece) const
  {
    std::vector<char> barred;
    for (Index v : piece.vertices)
    {
      barred.push_back(this->Marks.barred[this->Cut.originalVertex[v]]);
    }
    const bool plane = this->Result.mirror && this->Result.mirror->plane();
    std::vector<SuggestedCurve> cuts;
    for (Polyline& line :
      openingCuts(piece.mesh, plane ? this->Result.mirror->plane() : std::nullopt, barred))
    {
      cuts.push_back(proposedCut(std::move(line.points)));
    }
    return cuts;
  }

  /// Sets that are found cut by cut.
  /// \param first without which the surface cannot be laid flat
  void addSets(std::vector<CutSet>& found, const std::vector<SuggestedCurve>& first)
  {
    const SearchOptions& wanted = this->Options.search;
    const std::vector<SearchStrategy> strategies = searchStrategies(wanted);
    const auto needed = static_cast<Index>(first.size());
    if (wanted.maximumCuts > 0 && needed > wanted.maximumCuts)
    {
      return;
    }
    for (std::size_t k = 0; k < strategies.size() && !this->Run.cancelled(); ++k)
    {
      SearchOptions options = wanted;
      options.cuts = strategies[k].cuts;
      options.maximumCuts = wanted.maximumCuts > 0 ? wanted.maximumCuts : needed + maxAdded;
      TrialBudget budget(
        (first.empty() ? shareOfSearch : shareOpened) * (this->Budget.left() - this->MostMeasuring),
        this->Budget);
      found.push_back(searchCuts(this->subject(options, strategies[k].goal),
        this->start(first, strategies[k].goal, budget), budget, this->Run));
      const bool met = this->isFlat(bestOf(found, this->Options.search, this->Area));
      if ((met && (found.back().cuts.size() == first.size() || k > 0)) ||
        found.back().end == SearchEnd::GivenUp || found.front().end == SearchEnd::GivenUp ||
        this->Budget.left() <= this->MostMeasuring)
      {
        break; // others will hardly do better
      }
    }
  }

  TrialOutcome flattened(
    const std::vector<SuggestedCurve>& cuts, SearchGoal goal, TrialBudget& budget) const
  {
    return CutTrials(this->Mesh, this->Curves, this->Options.imprint, this->Options.flattening,
      goal, this->Weights)
      .run(linesOf(cuts), budget, this->Run);
  }

  const CutSet& start(
    const std::vector<SuggestedCurve>& first, SearchGoal goal, TrialBudget& budget)
  {
    const auto [start, isNew] = this->Start.emplace(goal, CutSet());
    CutSet& set = start->second;
    if (isNew)
    {
      set.cuts = first;
      set.outcome = this->flattened(first, goal, budget);
    }
    return set;
  }

  const TriangleMesh& Mesh;
  const std::vector<Polyline>& Curves;
  const SuggestionOptions& Options;
  Execution Run;         ///< silent
  RegionWeights Weights; ///< relative ones
  CutTrials Whole;
  ImprintedSurface Surface; ///< with the curves
  CutSurface Cut;           ///< along them
  std::vector<Piece> Pieces;
  VertexMarks Marks;
  double Area;
  std::map<SearchGoal, CutSet> Start; ///< the cuts that are needed anyway
  TrialBudget Budget;
  double MostMeasuring = 0.0; ///< of the budget
  CurveSuggestions Result;
};
}

CurveSuggestions suggestCurves(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SuggestionOptions& options, const Execution& execution)
{
  CurveSuggestions refused;
  refused.status = checkSuggestion(options, mesh.triangleCount(), curves);
  if (!refused.status.ok())
  {
    return refused;
  }
  const double most = options.search.maximumWork;
  TrialBudget budget(most > 0.0 ? 1e6 * most : std::numeric_limits<double>::infinity());
  budget.watch([&execution](double part) { execution.report(part, "Choosing cuts"); });
  Execution run = execution;
  if (run.preview)
  {
    run.preview = [&](const std::vector<Points3>& lines) {
      const SeamDrawing drawing(mesh); // they may be of a version with fewer triangles
      std::vector<Points3> drawn;
      for (const Points3& line : lines)
      {
        drawn.push_back(drawing.moved(line));
      }
      execution.preview(drawn);
    };
  }
  return withinMemory(
    [&] { return Suggesting(mesh, curves, options, std::move(budget), run).run(); });
}
}
