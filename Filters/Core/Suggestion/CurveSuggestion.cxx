// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CurveSuggestion.h"

#include "Base/Memory.h"
#include "Cut/PieceTopology.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/CutSetSearch.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/OpeningCuts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace flattening
{
namespace
{
/// Share of the remaining work for a search; nearly all where the surface had to be opened, which
/// takes many cuts.
constexpr double shareOfSearch = 0.5;
constexpr double shareOpened = 0.9;
/// Largest share of all work kept for measuring what each cut gains, by this many steps each.
constexpr double shareOfMeasuring = 0.3;
constexpr double stepsOfMeasuring = 40.0;
/// More sharp edges than these are those of a coarse mesh, not of a body.
constexpr std::size_t mostSharp = 48;
/// The bound for sharp edges where none is given: such a net is exact but for rounding.
constexpr double nearlyFlat = 1e-3;
/// Up to this many cuts are searched for once.
constexpr Index singleSearch = 2;

/// One way to search, beside the options.
struct SearchWay
{
  SuggestedCuts cuts = SuggestedCuts::All;
  SearchGoal goal = SearchGoal::Energy;
};

/// The ways to search one after the other, the most promising first: by two goals, and where darts
/// and seams are wanted also with either alone.
std::vector<SearchWay> searchWays(const SearchOptions& options)
{
  std::vector<SearchWay> all;
  for (SuggestedCuts cuts : { SuggestedCuts::All, SuggestedCuts::Darts, SuggestedCuts::Seams })
  {
    if (cuts == options.cuts || options.cuts == SuggestedCuts::All)
    {
      all.push_back({ cuts, SearchGoal::Energy });
      all.push_back({ cuts, options.bound > 0.0 ? SearchGoal::Strain : SearchGoal::Area });
    }
  }
  all.resize(options.maximumCuts <= singleSearch ? 1 : all.size());
  return all;
}

bool isPaired(const std::vector<SuggestedCurve>& cuts)
{
  return std::any_of(
    cuts.begin(), cuts.end(), [](const SuggestedCurve& cut) { return cut.mirrorOf != none; });
}

class Suggesting
{
public:
  Suggesting(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
    const SuggestionOptions& options, const Execution& execution)
    : Mesh(mesh)
    , Curves(curves)
    , Options(options)
    , Run(execution)
    , Weights(relativeWeights(mesh, options.weights))
    , Whole(mesh, curves, options.imprint, options.flattening, SearchGoal::Energy, this->Weights)
    , Area(mesh.area())
    , Budget(options.search.maximumWork > 0.0 ? 1e6 * options.search.maximumWork
                                              : std::numeric_limits<double>::infinity())
  {
  }

  CurveSuggestions run()
  {
    const ImprintedSurface surface = imprintCurves(this->Mesh, this->Curves, this->Options.imprint);
    if (!surface.status.ok())
    {
      return refusal(surface.status);
    }
    if (this->Options.search.symmetric)
    {
      this->findMirror();
    }
    const std::vector<SuggestedCurve> first = this->neededCuts(surface, false);
    CutSet uncut;
    uncut.outcome = this->Whole.run({}, this->Budget, this->Run);
    if (this->Run.cancelled())
    {
      return refusal({ StatusCode::Cancelled, "cancelled before any cut was chosen" });
    }
    this->MostMeasuring = std::min(shareOfMeasuring * this->Budget.left(),
      stepsOfMeasuring * this->Mesh.triangleCount() * this->Options.search.maximumCuts);
    const bool flat = uncut.outcome.valid && this->withinBound(uncut.outcome.strainP95);
    const std::optional<CutSet> sharp =
      flat ? std::nullopt : this->sharpSet(surface, !uncut.outcome.valid);
    const auto seams = static_cast<Index>(first.size());
    if (seams > this->Options.search.maximumCuts && !uncut.outcome.valid && !sharp)
    {
      return refusal({ StatusCode::InvalidOption,
        "the greatest number of cuts is " + std::to_string(this->Options.search.maximumCuts) +
          ", and to open the surface takes " + std::to_string(seams) + " seams",
        {}, { { Remedy::Give, "a number from " + std::to_string(seams) } } });
    }
    const CutSet best = this->search(uncut, first, sharp);
    this->Result.curves = best.cuts;
    if (!isPaired(best.cuts))
    {
      this->Result.mirror.reset();
    }
    this->nameCuts();
    this->measureCuts(uncut.outcome, best.outcome);
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

  bool withinBound(double strain) const
  {
    return this->Options.search.bound > 0.0 && strain <= this->Options.search.bound;
  }

  /// Whether one set is before another: what has a flattening before what has none; then what meets
  /// the bound by its price, before what does not by its strain. Without a bound by the product of
  /// the mean of the rigid energy and, counted twice, the square of the mean change of area.
  bool better(const CutSet& a, const CutSet& b) const
  {
    const auto merit = [this](const CutSet& set) {
      const SearchOptions& search = this->Options.search;
      const TrialOutcome& outcome = set.outcome;
      if (!outcome.valid)
      {
        return std::pair(2, 0.0);
      }
      if (search.bound == 0.0)
      {
        return std::pair(0, std::cbrt(outcome.energy * std::pow(outcome.areaError, 4.0)));
      }
      double price = 0.0;
      for (const SuggestedCurve& cut : set.cuts)
      {
        price += search.fixedPrice + cut.length / std::sqrt(this->Area / pi);
      }
      return this->withinBound(outcome.strainP95) ? std::pair(0, price)
                                                  : std::pair(1, outcome.strainP95);
    };
    return merit(a) < merit(b);
  }

  void findMirror()
  {
    if (const std::optional<SymmetryPlane> plane = findSymmetryPlane(this->Mesh))
    {
      this->Result.mirror = SurfaceMirror(*plane);
    }
    else if (auto intrinsic = IntrinsicMirror::find(this->Mesh, this->Run))
    {
      this->Result.mirror = SurfaceMirror(std::move(intrinsic));
    }
    // One that holds only nearly is no reason to keep a single cut to its axis.
    const bool alone = this->Options.search.maximumCuts == 1 && this->Result.mirror &&
      this->Result.mirror->intrinsic() && this->Result.mirror->error > SurfaceMirror::exact;
    if (this->Result.mirror &&
      (alone || !mirrorsWeights(this->Mesh, this->Weights, *this->Result.mirror)))
    {
      this->Result.mirror.reset();
    }
  }

  /// Cuts without which a piece cannot be laid flat at all, or those along its sharp edges.
  std::vector<SuggestedCurve> neededCuts(const ImprintedSurface& surface, bool sharp) const
  {
    std::vector<SuggestedCurve> cuts;
    const CutSurface cutAlready = cutSurface(surface.mesh, surface.curves);
    const VertexMarks marks = markVertices(surface, this->Options.search);
    for (const Piece& piece : extractPieces(cutAlready))
    {
      std::vector<char> barred;
      for (Index v : piece.vertices)
      {
        barred.push_back(marks.barred[cutAlready.originalVertex[v]]);
      }
      const bool plane = this->Result.mirror && this->Result.mirror->plane();
      for (Polyline& line : sharp
          ? sharpEdges(piece.mesh, barred)
          : openingCuts(piece.mesh, plane ? this->Result.mirror->plane() : std::nullopt, barred))
      {
        SuggestedCurve cut;
        cut.length = lengthOf(line.points);
        cut.curve = std::move(line);
        cuts.push_back(std::move(cut));
      }
    }
    return cuts;
  }

  /// All sharp edges as cuts, with what then opens the pieces, less what the bound does not need.
  /// None where they do not meet it, or are too many.
  /// \param opens whether the surface cannot be laid flat without cuts, which may then be of any kind
  std::optional<CutSet> sharpSet(const ImprintedSurface& surface, bool opens)
  {
    const SearchOptions& wanted = this->Options.search;
    CutSet set;
    set.cuts = this->neededCuts(surface, true);
    if (set.cuts.empty() || set.cuts.size() > mostSharp)
    {
      return {};
    }
    std::vector<Polyline> all = this->Curves;
    for (const SuggestedCurve& cut : set.cuts)
    {
      all.push_back(cut.curve);
    }
    const ImprintedSurface parted = imprintCurves(this->Mesh, all, this->Options.imprint);
    if (!parted.status.ok())
    {
      return {};
    }
    for (SuggestedCurve& cut : this->neededCuts(parted, false))
    {
      set.cuts.push_back(std::move(cut));
    }
    const double bound = wanted.bound > 0.0 ? wanted.bound : nearlyFlat;
    set.outcome = this->Whole.run(linesOf(set.cuts), this->Budget, this->Run);
    if (!set.outcome.valid || set.outcome.strainP95 > bound)
    {
      return {};
    }
    thinCuts(this->Whole, bound, std::numeric_limits<double>::infinity(), set.cuts, set.outcome,
      this->Budget, this->Run);
    this->makeDarts(surface, set);
    set.end = wanted.bound > 0.0 ? SearchEnd::BoundMet : SearchEnd::NothingHelps;
    const auto is = [&](CurveType type) {
      return std::any_of(set.cuts.begin(), set.cuts.end(),
        [type](const SuggestedCurve& cut) { return cut.curve.type == type; });
    };
    const bool kinds = opens ||
      !is(wanted.cuts == SuggestedCuts::Darts   ? CurveType::Seam
          : wanted.cuts == SuggestedCuts::Seams ? CurveType::Dart
                                                : CurveType::Accessory);
    return kinds && static_cast<Index>(set.cuts.size()) <= wanted.maximumCuts &&
        set.outcome.cutLength() <= wanted.cutLengthLimit()
      ? std::optional<CutSet>(set)
      : std::nullopt;
  }

  /// Cuts that end inside at one end are darts. Last, since they may begin on the others.
  void makeDarts(const ImprintedSurface& surface, CutSet& set)
  {
    const CutSurface cut = cutSurface(surface.mesh, surface.curves);
    std::vector<SuggestedCurve> cuts;
    std::vector<SuggestedCurve> darts;
    for (std::size_t k = 0; k < set.cuts.size(); ++k)
    {
      const auto ends = [&](const Point3& point) {
        for (Index v = 0; v < cut.mesh.vertexCount(); ++v)
        {
          if (cut.mesh.onBoundary(v) && cut.mesh.point(v) == point)
          {
            return true;
          }
        }
        for (std::size_t j = 0; j < set.cuts.size(); ++j)
        {
          const Points3& other = set.cuts[j].curve.points;
          if (j != k && std::find(other.begin(), other.end(), point) != other.end())
          {
            return true;
          }
        }
        return false;
      };
      Points3& points = set.cuts[k].curve.points;
      const bool first = ends(points.front());
      const bool dart = points.front() != points.back() && first != ends(points.back());
      if (dart && !first)
      {
        std::reverse(points.begin(), points.end());
      }
      (dart ? darts : cuts).push_back(set.cuts[k]);
      (dart ? darts : cuts).back().curve.type = dart ? CurveType::Dart : CurveType::Seam;
    }
    cuts.insert(cuts.end(), darts.begin(), darts.end());
    set.cuts = std::move(cuts);
    set.outcome = this->Whole.run(linesOf(set.cuts), this->Budget, this->Run);
  }

  /// The best set that is found, which is never worse than no cuts.
  CutSet search(const CutSet& uncut, const std::vector<SuggestedCurve>& first,
    const std::optional<CutSet>& sharp)
  {
    const SearchOptions& wanted = this->Options.search;
    std::vector<CutSet> found;
    if (static_cast<Index>(first.size()) > wanted.maximumCuts)
    {
      this->Result.end = SearchEnd::CutsUsedUp;
      this->Result.cutsNeeded = sharp ? 0.0 : static_cast<double>(first.size());
      return sharp ? *sharp : uncut;
    }
    const auto better = [this](const CutSet& a, const CutSet& b) { return this->better(a, b); };
    std::vector<SearchWay> ways = searchWays(wanted);
    ways.resize(sharp ? 1 : ways.size());
    for (std::size_t k = 0; k < ways.size() && !this->Run.cancelled(); ++k)
    {
      SearchOptions options = wanted;
      options.cuts = ways[k].cuts;
      const double left = this->Budget.left() - this->MostMeasuring;
      TrialBudget budget((first.empty() ? shareOfSearch : shareOpened) * left);
      const auto count = static_cast<double>(ways.size());
      found.push_back(
        searchCuts({ this->Mesh, this->Curves, this->Options.imprint, this->Options.flattening,
                     options, this->Result.mirror, this->Weights, ways[k].goal },
          this->start(first, ways[k].goal, budget), budget,
          this->Run.part(static_cast<double>(k) / count, static_cast<double>(k + 1) / count)));
      this->Budget.add(budget);
      const CutSet& set = found.back();
      const TrialOutcome& least = std::min_element(found.begin(), found.end(), better)->outcome;
      const bool met = least.valid && this->withinBound(least.strainP95);
      if ((met && (set.cuts.size() == first.size() || k > 0)) ||
        found.front().end == SearchEnd::GivenUp || this->Budget.left() <= this->MostMeasuring)
      {
        break; // others will hardly do better
      }
    }
    if (found.empty())
    {
      this->Result.end = SearchEnd::Interrupted;
      return uncut;
    }
    const auto best = std::min_element(found.begin(), found.end(), better);
    if (sharp && better(*sharp, *best))
    {
      *best = *sharp;
    }
    const bool limited = std::any_of(found.begin(), found.end(),
      [](const CutSet& one) { return one.end == SearchEnd::WorkUsedUp; });
    this->Result.end = this->Run.cancelled() ? SearchEnd::Interrupted
      : limited                              ? SearchEnd::WorkUsedUp
                                             : best->end;
    this->Result.cutsNeeded = best->cutsNeeded;
    const TrialOutcome& with = best->outcome;
    const bool worse = wanted.bound > 0.0 ? with.strainP95 > uncut.outcome.strainP95
                                          : with.energy > uncut.outcome.energy;
    return uncut.outcome.valid && (worse || !with.valid) ? uncut : *best;
  }

  const CutSet& start(
    const std::vector<SuggestedCurve>& first, SearchGoal goal, TrialBudget& budget)
  {
    std::optional<CutSet>& set = this->Start[goal];
    if (!set)
    {
      set.emplace();
      set->cuts = first;
      set->outcome = CutTrials(this->Mesh, this->Curves, this->Options.imprint,
        this->Options.flattening, goal, this->Weights)
                       .run(linesOf(first), budget, this->Run);
    }
    return *set;
  }

  /// What each cut gives after those before it, now that some are shorter or gone; not known where
  /// the work does not allow it.
  void measureCuts(const TrialOutcome& without, const TrialOutcome& with)
  {
    std::vector<SuggestedCurve>& cuts = this->Result.curves;
    // After each cut or pair but the last, which is known.
    std::vector<std::size_t> ends;
    std::vector<std::vector<Polyline>> lines;
    for (std::size_t k = 0; k < cuts.size(); ++k)
    {
      if (k + 1 == cuts.size() || cuts[k + 1].mirrorOf == none)
      {
        ends.push_back(k + 1);
        lines.push_back(
          linesOf({ cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(k + 1) }));
      }
    }
    if (!lines.empty())
    {
      lines.back().clear();
    }
    std::vector<TrialOutcome> after = this->Whole.runAll(lines, this->Budget, this->Run);
    TrialOutcome before = without;
    this->Result.strainBefore = before.known(before.strainP95);
    this->Result.rigidEnergyBefore = before.known(before.energy / this->Area);
    std::size_t begin = 0;
    for (std::size_t e = 0; e < ends.size(); ++e)
    {
      const TrialOutcome& now = e + 1 == ends.size() ? with : after[e];
      for (std::size_t j = begin; j < ends[e]; ++j)
      {
        cuts[j].areaErrorBefore = before.known(before.areaError);
        cuts[j].areaErrorAfter = now.known(now.areaError);
        cuts[j].strainBefore = before.known(before.strainP95);
        cuts[j].strainAfter = now.known(now.strainP95);
        cuts[j].gain = (before.known(before.energy) - now.known(now.energy)) / this->Area;
      }
      begin = ends[e];
      before = now;
    }
    this->Result.strainAfter = with.known(with.strainP95);
    this->Result.rigidEnergyAfter = with.known(with.energy / this->Area);
    this->Result.boundMet = with.valid && this->withinBound(with.strainP95);
    this->Result.worstPlace = with.worstPlace;
  }

  /// Numbers darts and seams in their order, beside the names that there are.
  void nameCuts()
  {
    Index number = 0;
    for (SuggestedCurve& cut : this->Result.curves)
    {
      const char* kind = cut.curve.type == CurveType::Dart ? "dart " : "seam ";
      do
      {
        cut.curve.name = kind + std::to_string(++number);
      } while (std::any_of(this->Curves.begin(), this->Curves.end(),
        [&](const Polyline& curve) { return curve.name == cut.curve.name; }));
    }
  }

  const TriangleMesh& Mesh;
  const std::vector<Polyline>& Curves;
  const SuggestionOptions& Options;
  const Execution& Run;
  RegionWeights Weights; ///< relative ones
  CutTrials Whole;
  double Area;
  std::map<SearchGoal, std::optional<CutSet>> Start; ///< the cuts that are needed anyway
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
  return withinMemory([&] { return Suggesting(mesh, curves, options, execution).run(); });
}
}
