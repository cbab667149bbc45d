// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CurveSuggestion.h"

#include "Base/Memory.h"
#include "Cut/PieceTopology.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/CutSetSearch.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/LineSuggestion.h"
#include "Suggestion/OpeningCuts.h"

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
/// Up to so many cuts are searched for once.
constexpr Index singleSearch = 2;
/// The least share of the work that the first way to search may take.
constexpr double firstShare = 0.5;
/// Larger surfaces may take more work in proportion.
constexpr double smallSurface = 5000.0;

/// One way to search, beside the options.
struct Way
{
  SearchGoal goal = SearchGoal::Energy;
  bool mirrored = true;
  double fixedPrice = 1.0; ///< times that of the options
  bool unsettled = false;  ///< see SearchOptions
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
  {
    for (Index t = 0; t < mesh.triangleCount(); ++t)
    {
      this->Area += mesh.area(t);
    }
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
    for (const Piece& piece : extractPieces(cutSurface(surface.mesh, surface.curves)))
    {
      const bool plane = this->Result.mirror && this->Result.mirror->plane();
      for (Polyline& line :
        openingCuts(piece.mesh, plane ? this->Result.mirror->plane() : std::nullopt))
      {
        SuggestedCurve cut;
        for (std::size_t k = 1; k < line.points.size(); ++k)
        {
          cut.length += (line.points[k] - line.points[k - 1]).norm();
        }
        cut.curve = std::move(line);
        cuts.push_back(std::move(cut));
      }
    }
    return cuts;
  }

  /// The ways to search: the first alone where few cuts may be made.
  std::vector<Way> ways() const
  {
    // A mirror that holds only nearly is no reason to keep a single cut to its axis.
    const bool alone = this->Options.search.maximumCuts == 1 && this->Result.mirror &&
      this->Result.mirror->intrinsic() && this->Result.mirror->error > SurfaceMirror::exact;
    const bool mirrored = this->Result.mirror.has_value() && !alone;
    std::vector<Way> all{ { SearchGoal::Energy, mirrored, 1.0 } };
    if (this->Options.search.maximumCuts <= singleSearch)
    {
      return all;
    }
    if (this->Options.search.bound > 0.0)
    {
      all.push_back({ SearchGoal::Energy, mirrored, 1.0, true });
      all.push_back({ SearchGoal::Strain, mirrored, 1.0, true });
      all.push_back({ SearchGoal::Strain, mirrored, 1.0 });
    }
    all.push_back({ SearchGoal::Energy, mirrored, 2.5 });
    if (mirrored && this->Result.mirror->error > SurfaceMirror::exact)
    {
      const std::size_t count = all.size();
      for (std::size_t k = 0; k < count; ++k)
      {
        all.push_back(all[k]);
        all.back().mirrored = false;
      }
    }
    return all;
  }

  CutSet search(const std::vector<SuggestedCurve>& first)
  {
    std::optional<CutSet> best;
    double leastMerit = 0.0;
    bool limited = false;
    const std::vector<Way> all = this->ways();
    for (std::size_t k = 0; k < all.size() && !this->Run.cancelled(); ++k)
    {
      SearchOptions options = this->Options.search;
      options.goal = all[k].goal;
      options.fixedPrice *= all[k].fixedPrice;
      options.unsettled = all[k].unsettled;
      const double share =
        std::max(1.0 / static_cast<double>(all.size() - k), k == 0 ? firstShare : 0.0);
      options.maximumWork = share * (this->mostWork() - this->Result.work);
      const double part = 0.9 / static_cast<double>(all.size());
      CutSet set =
        searchCuts({ this->Mesh, this->Curves, this->Options.imprint, this->Options.flattening,
                     options, all[k].mirrored ? this->Result.mirror : std::nullopt, this->Weights },
          this->start(first, all[k].goal),
          this->Run.part(part * static_cast<double>(k), part * static_cast<double>(k + 1)));
      this->Result.trials += set.trials;
      this->Result.work += set.work;
      limited = limited || set.end == SearchEnd::WorkUsedUp;
      const double merit =
        this->merit(set) * (this->Result.mirror && !all[k].mirrored ? mirrorWorth : 1.0);
      if (!best || merit < leastMerit)
      {
        best = std::move(set);
        leastMerit = merit;
      }
      if (best->cuts.size() == first.size() && this->withinBound(best->outcome.strainP95))
      {
        break; // nothing is to be cut
      }
      if (best->end == SearchEnd::GivenUp || this->workUsedUp())
      {
        break; // nor will other ways get there
      }
    }
    this->Result.end = limited ? SearchEnd::WorkUsedUp : best->end;
    this->Result.cutsNeeded = best->cutsNeeded;
    return std::move(*best);
  }

  bool workUsedUp() const { return this->Result.work >= this->mostWork(); }

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

  bool withinBound(double strain) const
  {
    return this->Options.search.bound > 0.0 && strain <= this->Options.search.bound;
  }

  /// What is less is better: sets that meet the bound by their price, before those that do not by
  /// their strain; without a bound by the energy.
  double merit(const CutSet& set) const
  {
    constexpr double unmet = 1e6;
    constexpr double useless = 1e12;
    const SearchOptions& search = this->Options.search;
    if (!set.outcome.valid)
    {
      return useless;
    }
    if (search.bound == 0.0)
    {
      return set.outcome.energy / this->Area;
    }
    if (!this->withinBound(set.outcome.strainP95))
    {
      return unmet * (1.0 + set.outcome.strainP95);
    }
    double price = 0.0;
    for (const SuggestedCurve& cut : set.cuts)
    {
      price += search.fixedPrice + cut.length / std::sqrt(this->Area / pi);
    }
    return price;
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
    this->Result.strainBefore = before.strainP95;
    this->Result.rigidEnergyBefore = before.energy / this->Area;
    std::size_t begin = 0;
    for (std::size_t e = 0; e < ends.size(); ++e)
    {
      for (std::size_t j = begin; j < ends[e]; ++j)
      {
        cuts[j].areaErrorBefore = before.areaError;
        cuts[j].areaErrorAfter = after[e].areaError;
        cuts[j].strainBefore = before.strainP95;
        cuts[j].strainAfter = after[e].strainP95;
        cuts[j].gain = before.valid ? (before.energy - after[e].energy) / this->Area : 0.0;
      }
      begin = ends[e];
      before = after[e];
    }
    this->Result.strainAfter = before.strainP95;
    this->Result.rigidEnergyAfter = before.energy / this->Area;
    this->Result.boundMet = this->withinBound(before.strainP95);
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
  double Area = 0.0;
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
