// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CurveSuggestion.h"

#include "Base/Memory.h"
#include "Cut/PieceTopology.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/CutAdjustment.h"
#include "Suggestion/CutSetMerit.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/LineSuggestion.h"
#include "Suggestion/OpeningCuts.h"
#include "Suggestion/PieceSearch.h"
#include "Suggestion/SearchWays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace flattening
{
namespace
{
/// How much better cuts must be that are not mirrored.
constexpr double mirrorWorth = 1.2;
/// The least share of the work that the first way to search may take; and where the surface had to
/// be opened, which takes so many cuts that half the work might end none of the ways.
constexpr double firstShare = 0.5;
constexpr double firstShareOpened = 1.0;
/// The share of the work that searches may take, where their sets are then adjusted, and what of
/// the rest each of these may take but the last: more sets for a bound, which fewer of them meet.
constexpr double searchShare = 0.6;
constexpr double adjustingShare = 0.5;
constexpr std::size_t mostAdjusted = 3;
constexpr double adjustingShareForBound = 0.4;
constexpr std::size_t mostAdjustedForBound = 4;
/// What searches are of the progress.
constexpr double searchPart = 0.6;
/// Larger surfaces may take more work in proportion.
constexpr double smallSurface = 5000.0;

/// What one way has found.
struct FoundSet
{
  CutSet set;
  bool mirrored = true;
};

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
    , Merit(options.search, this->Area)
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
      if (this->Result.mirror && !mirrorsWeights(this->Mesh, this->Weights, *this->Result.mirror))
      {
        this->Result.mirror.reset();
      }
    }
    CutSet best = this->search(this->openingCutsOf(surface));
    if (this->Run.cancelled())
    {
      return refusal({ StatusCode::Cancelled, "cancelled while choosing cuts" });
    }
    this->Result.curves = best.cuts;
    this->nameCuts();
    this->measureCuts(best);
    return std::move(this->Result);
  }

private:
  static CurveSuggestions refusal(Status status)
  {
    CurveSuggestions refused;
    refused.status = std::move(status);
    return refused;
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
  }

  /// Cuts without which a piece cannot be laid flat at all.
  std::vector<SuggestedCurve> openingCutsOf(const ImprintedSurface& surface) const
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
      for (Polyline& line :
        openingCuts(piece.mesh, plane ? this->Result.mirror->plane() : std::nullopt, barred))
      {
        SuggestedCurve cut;
        cut.length = lengthOf(line.points);
        cut.curve = std::move(line);
        cuts.push_back(std::move(cut));
      }
    }
    return cuts;
  }

  CutSet search(const std::vector<SuggestedCurve>& first)
  {
    std::vector<FoundSet> found = this->searchAllWays(first);
    if (this->adjusts())
    {
      this->adjust(found, first.size());
    }
    const auto best =
      std::min_element(found.begin(), found.end(), [this](const FoundSet& a, const FoundSet& b) {
        return this->Merit.merit(a.set, this->worthOf(a)) <
          this->Merit.merit(b.set, this->worthOf(b));
      });
    const bool limited = std::any_of(found.begin(), found.end(),
      [](const FoundSet& one) { return one.set.end == SearchEnd::WorkUsedUp; });
    this->Result.end = limited ? SearchEnd::WorkUsedUp : best->set.end;
    this->Result.cutsNeeded = best->set.cutsNeeded;
    return std::move(best->set);
  }

  std::vector<FoundSet> searchAllWays(const std::vector<SuggestedCurve>& first)
  {
    std::vector<FoundSet> found;
    const std::vector<SearchWay> all = searchWays(this->Options.search, this->Result.mirror);
    for (std::size_t k = 0; k < all.size() && (k == 0 || !this->Run.cancelled()); ++k)
    {
      SearchOptions options = this->Options.search;
      options.goal = all[k].goal;
      options.fixedPrice *= all[k].fixedPrice;
      options.unsettled = all[k].unsettled;
      const double least = first.empty() ? firstShare : firstShareOpened;
      const double share =
        std::max(1.0 / static_cast<double>(all.size() - k), k == 0 ? least : 0.0);
      options.maximumWork = share * (this->searchWork() - this->Result.work);
      const double part = searchPart / static_cast<double>(all.size());
      found.push_back(
        { searchCuts({ this->Mesh, this->Curves, this->Options.imprint, this->Options.flattening,
                       options, this->mirrorOf(all[k].mirrored), this->Weights },
            this->start(first, all[k].goal),
            this->Run.part(part * static_cast<double>(k), part * static_cast<double>(k + 1))),
          all[k].mirrored });
      const CutSet& set = found.back().set;
      this->Result.trials += set.trials;
      this->Result.work += set.work;
      const bool nothingToCut =
        set.cuts.size() == first.size() && this->Merit.withinBound(set.outcome.strainP95);
      const bool givenUp = found.front().set.end == SearchEnd::GivenUp;
      if (nothingToCut || givenUp || this->Result.work >= this->searchWork())
      {
        break; // nor will other ways get there
      }
    }
    return found;
  }

  std::optional<SurfaceMirror> mirrorOf(bool mirrored) const
  {
    return mirrored ? this->Result.mirror : std::nullopt;
  }

  /// Whether cuts are moved about once they are found: not a few, which are wanted soon.
  bool adjusts() const { return !searchesOnce(this->Options.search); }

  /// The sets that promise most; one of them as if strain were lowered with ease.
  void adjust(std::vector<FoundSet>& found, std::size_t firstCount)
  {
    const auto promiseMore = [this](double power) {
      return [this, power](const FoundSet& a, const FoundSet& b) {
        return this->Merit.promise(a.set, this->worthOf(a), power) <
          this->Merit.promise(b.set, this->worthOf(b), power);
      };
    };
    std::stable_sort(found.begin(), found.end(), promiseMore(unmetWeight));
    const auto same = [](const FoundSet& a, const FoundSet& b) {
      return a.mirrored == b.mirrored && a.set.outcome.paths == b.set.outcome.paths;
    };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    const bool bound = this->Options.search.bound > 0.0;
    const std::size_t most = bound ? mostAdjustedForBound : mostAdjusted;
    if (bound && found.size() > most)
    {
      const auto cheap = std::min_element(found.begin() + 1, found.end(), promiseMore(1.0));
      std::rotate(found.begin() + 1, cheap, cheap + 1);
    }
    const std::size_t count = std::min(found.size(), most);
    for (std::size_t k = 0; k < count; ++k)
    {
      if (found[k].set.end == SearchEnd::GivenUp)
      {
        continue;
      }
      const double share = k + 1 == count ? 1.0 : bound ? adjustingShareForBound : adjustingShare;
      TrialBudget budget(1e6 * share * (this->mostWork() - this->Result.work));
      const double part = (1.0 - searchPart) / static_cast<double>(count);
      const double begin = searchPart + part * static_cast<double>(k);
      adjustCuts({ this->Mesh, this->Curves, this->Options.imprint, this->Options.flattening,
                   this->Options.search, this->mirrorOf(found[k].mirrored), this->Weights },
        firstCount, found[k].set, budget, this->Run.part(begin, begin + part));
      this->Result.trials += budget.trials();
      this->Result.work += 1e-6 * budget.work();
    }
  }

  double searchWork() const { return (this->adjusts() ? searchShare : 1.0) * this->mostWork(); }

  double mostWork() const
  {
    const double most = this->Options.search.maximumWork;
    return most > 0.0 ? most * std::max(1.0, this->Mesh.triangleCount() / smallSurface)
                      : std::numeric_limits<double>::infinity();
  }

  const CutSet& start(const std::vector<SuggestedCurve>& first, SearchGoal goal)
  {
    std::optional<CutSet>& set = this->Start[goal];
    if (!set)
    {
      set.emplace();
      set->cuts = first;
      set->outcome = CutTrials(this->Mesh, this->Curves, this->Options.imprint,
        this->Options.flattening, goal, this->Weights)
                       .run(linesOf(first), this->Run);
    }
    return *set;
  }

  double worthOf(const FoundSet& found) const
  {
    return this->Result.mirror && !found.mirrored ? mirrorWorth : 1.0;
  }

  /// What each cut gives after those before it, now that some are shorter or gone.
  void measureCuts(const CutSet& set)
  {
    std::vector<SuggestedCurve>& cuts = this->Result.curves;
    const TrialOutcome* const start =
      this->Start[SearchGoal::Energy] ? &this->Start[SearchGoal::Energy]->outcome : nullptr;
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
    std::vector<TrialOutcome> after = this->Whole.runAll(lines, this->Run);
    if (!after.empty())
    {
      after.back() = set.outcome;
    }
    TrialOutcome before = start && start->paths.empty() ? *start : this->Whole.run({}, this->Run);
    this->Result.strainBefore = before.known(before.strainP95);
    this->Result.rigidEnergyBefore = before.known(before.energy / this->Area);
    std::size_t begin = 0;
    for (std::size_t e = 0; e < ends.size(); ++e)
    {
      for (std::size_t j = begin; j < ends[e]; ++j)
      {
        cuts[j].areaErrorBefore = before.known(before.areaError);
        cuts[j].areaErrorAfter = after[e].known(after[e].areaError);
        cuts[j].strainBefore = before.known(before.strainP95);
        cuts[j].strainAfter = after[e].known(after[e].strainP95);
        cuts[j].gain = (before.known(before.energy) - after[e].known(after[e].energy)) / this->Area;
      }
      begin = ends[e];
      before = after[e];
    }
    this->Result.strainAfter = before.known(before.strainP95);
    this->Result.rigidEnergyAfter = before.known(before.energy / this->Area);
    this->Result.boundMet = before.valid && this->Merit.withinBound(before.strainP95);
    this->Result.worstPlace = before.worstPlace;
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
  CutSetMerit Merit;
  std::map<SearchGoal, std::optional<CutSet>> Start; ///< the cuts that are needed anyway
  CurveSuggestions Result;
};
}

CurveSuggestions suggestCurves(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SuggestionOptions& options, const Execution& execution)
{
  CurveSuggestions refused;
  refused.status = checkSearch(options.search, curves);
  if (refused.status.ok())
  {
    refused.status = checkWeights(options.weights, mesh.triangleCount());
  }
  if (!refused.status.ok())
  {
    return refused;
  }
  if (options.search.cuts == SuggestedCuts::Lines)
  {
    return suggestLines(mesh, curves, options, execution);
  }
  return withinMemory([&] { return Suggesting(mesh, curves, options, execution).run(); });
}
}
