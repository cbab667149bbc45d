// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CurveSuggestion.h"

#include "Base/Memory.h"
#include "Cut/PieceTopology.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/CutCandidates.h"
#include "Suggestion/CutSearch.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/OpeningCuts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// A cut whose price is sqrt(area / pi) has to lower the energy by this share to be worth it.
constexpr double leastShare = 0.01;
/// Where a surface had to be cut open, a piece with more strain than this is divided by seams
/// before it is shaped by darts.
constexpr double dividedStrain = 0.1;

class Suggesting
{
public:
  Suggesting(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
    const SuggestionOptions& options, const Execution& execution)
    : Mesh(mesh)
    , Curves(curves)
    , Options(options)
    , Search(options.search)
    , Run(execution)
    , Whole(mesh, curves, options.imprint, options.flattening)
    , TrialsLeft(options.search.maximumTrials)
  {
    for (Index t = 0; t < mesh.triangleCount(); ++t)
    {
      this->Area += mesh.area(t);
    }
  }

  CurveSuggestions run()
  {
    const Status soundCurves =
      imprintCurves(this->Mesh, this->Curves, this->Options.imprint).status;
    if (!soundCurves.ok())
    {
      return refusal(soundCurves);
    }
    if (this->Search.symmetric)
    {
      this->Result.mirror = findMirrorPlane(this->Mesh);
    }
    this->openUp();
    this->Now = this->Whole.run(this->chosen(), this->Run);
    this->Result.strainBefore = this->Now.strainP95;
    this->Result.rigidEnergyBefore = this->Now.energy / this->Area;
    while (!this->finished() && this->addCut())
    {
      this->Run.report(
        std::min(0.9, static_cast<double>(this->Result.cuts.size()) / this->Search.maximumCuts),
        "Choosing cuts");
    }
    if (this->withinBound(this->Now.strainP95))
    {
      this->thin();
    }
    else
    {
      this->refit();
    }
    if (this->Run.cancelled())
    {
      return refusal({ StatusCode::Cancelled, "cancelled while choosing cuts" });
    }
    this->nameCuts();
    this->measureCuts();
    this->Result.strainAfter = this->Now.strainP95;
    this->Result.rigidEnergyAfter = this->Now.energy / this->Area;
    this->Result.boundMet = this->withinBound(this->Now.strainP95);
    this->Result.trials = this->Search.maximumTrials - this->TrialsLeft;
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
    return this->Search.bound > 0.0 && strain <= this->Search.bound;
  }

  bool finished() const
  {
    return this->withinBound(this->Now.strainP95) || this->TrialsLeft <= 0 ||
      this->Run.cancelled() ||
      static_cast<Index>(this->Result.cuts.size()) >= this->Search.maximumCuts;
  }

  /// Cuts without which a piece cannot be laid flat at all.
  void openUp()
  {
    const ImprintedSurface surface = imprintCurves(this->Mesh, this->Curves, this->Options.imprint);
    for (const Piece& piece : extractPieces(cutSurface(surface.mesh, surface.curves)))
    {
      for (Polyline& line : openingCuts(piece.mesh, this->Result.mirror))
      {
        SuggestedCurve cut;
        for (std::size_t k = 1; k < line.points.size(); ++k)
        {
          cut.length += (line.points[k] - line.points[k - 1]).norm();
        }
        cut.curve = std::move(line);
        this->Result.cuts.push_back(std::move(cut));
      }
    }
    this->OpeningCount = this->Result.cuts.size();
  }

  void thin()
  {
    if (this->OpeningCount == 0)
    {
      thinCuts(
        this->Whole, this->Search.bound, this->Result.cuts, this->Now, this->TrialsLeft, this->Run);
    }
  }

  /// Looks for each cut anew, given all others, where it may now lie better or be shorter.
  void refit()
  {
    for (std::size_t k = this->OpeningCount; k < this->Result.cuts.size() && this->TrialsLeft > 0;
         ++k)
    {
      if (this->Result.cuts[k].mirrorOf != none)
      {
        continue;
      }
      const std::vector<SuggestedCurve> cuts = this->Result.cuts;
      const TrialOutcome now = this->Now;
      this->Result.cuts = withShare(cuts, k, 0.0);
      this->Now = this->Whole.run(this->chosen(), this->Run);
      if (!this->Now.valid || !this->addCut() || !this->Now.soundAfter(now) ||
        this->Now.energy >= now.energy || this->Result.cuts.size() > cuts.size())
      {
        this->Result.cuts = cuts;
        this->Now = now;
      }
    }
  }

  /// What each cut gives after those before it, now that some are shorter or gone.
  void measureCuts()
  {
    std::vector<SuggestedCurve>& cuts = this->Result.cuts;
    std::vector<Polyline> lines;
    TrialOutcome before = this->Whole.run(lines, this->Run);
    for (std::size_t k = 0; k < cuts.size() && !this->Run.cancelled(); ++k)
    {
      lines.push_back(cuts[k].curve);
      const bool paired = k + 1 < cuts.size() && cuts[k + 1].mirrorOf == static_cast<Index>(k);
      if (paired)
      {
        lines.push_back(cuts[++k].curve);
      }
      const TrialOutcome after = this->Whole.run(lines, this->Run);
      for (std::size_t j = paired ? k - 1 : k; j <= k; ++j)
      {
        cuts[j].strainBefore = before.strainP95;
        cuts[j].strainAfter = after.strainP95;
        cuts[j].gain = before.valid ? (before.energy - after.energy) / this->Area : 0.0;
      }
      before = after;
    }
  }

  /// Numbers darts and seams in their order, beside the names that there are.
  void nameCuts()
  {
    Index number = 0;
    for (SuggestedCurve& cut : this->Result.cuts)
    {
      const char* kind = cut.curve.type == CurveType::Dart ? "dart " : "seam ";
      do
      {
        cut.curve.name = kind + std::to_string(++number);
      } while (std::any_of(this->Curves.begin(), this->Curves.end(),
        [&](const Polyline& curve) { return curve.name == cut.curve.name; }));
    }
  }

  std::vector<Polyline> chosen() const
  {
    std::vector<Polyline> cuts;
    for (const SuggestedCurve& cut : this->Result.cuts)
    {
      cuts.push_back(cut.curve);
    }
    return cuts;
  }

  /// The curves that the surface has anyway, and the cuts chosen so far.
  std::vector<Polyline> withChosen() const
  {
    std::vector<Polyline> all = this->Curves;
    const std::vector<Polyline> cuts = this->chosen();
    all.insert(all.end(), cuts.begin(), cuts.end());
    return all;
  }

  double lengthLeft() const
  {
    double left = this->Search.maximumCutLength;
    for (const SuggestedCurve& cut : this->Result.cuts)
    {
      left -= cut.length;
    }
    return left;
  }

  /// One round. False where no piece has a cut that is worth it.
  bool addCut()
  {
    const ImprintedSurface surface =
      imprintCurves(this->Mesh, this->withChosen(), this->Options.imprint);
    const CutSurface cut = cutSurface(surface.mesh, surface.curves);
    const std::vector<Piece> pieces = extractPieces(cut);
    std::vector<std::size_t> order;
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      if (this->Now.pieceStrains.size() != pieces.size() ||
        !this->withinBound(this->Now.pieceStrains[p]))
      {
        order.push_back(p);
      }
    }
    if (this->Now.pieceStrains.size() == pieces.size())
    {
      std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
        return this->Now.pieceEnergies[a] > this->Now.pieceEnergies[b];
      });
    }
    for (std::size_t p : order)
    {
      const bool known = this->Now.pieceStrains.size() == pieces.size();
      if (this->cutPiece(pieces[p], surface, known ? this->Now.pieceStrains[p] : 0.0))
      {
        return true;
      }
    }
    return false;
  }

  bool cutPiece(const Piece& piece, const ImprintedSurface& surface, double strain)
  {
    const auto [barred, worth] = this->markVertices(piece, surface);
    const SearchedPiece searched(piece.mesh, barred, worth, this->Result.mirror);
    const ScaleFactor factor(searched.mesh(), {}, this->Run);
    if (!factor.ok())
    {
      return false;
    }
    const double left = this->lengthLeft();
    const CutTrials trials(
      this->Mesh, this->withChosen(), this->Options.imprint, this->Options.flattening);
    TrialOutcome before = this->Now;
    if (!before.valid)
    {
      // Nothing could be flattened: whatever can is better.
      before.energy = 1e3 * this->Area;
      before.severity = std::numeric_limits<int>::max();
      before.flipped = searched.mesh().triangleCount();
      before.overlaps = searched.mesh().halfedgeCount();
    }
    SearchOptions search = this->Search;
    if (search.cuts == SuggestedCuts::All && this->OpeningCount > 0 && strain > dividedStrain)
    {
      search.cuts = SuggestedCuts::Seams;
    }
    const std::vector<CutPlan> plans = planCuts(searched, factor, search, left, this->Run);
    const std::optional<TriedCut> best = CutSearch(searched, trials, this->Search, before)
                                           .run(plans, left, this->TrialsLeft, this->Run);
    return best && this->accept(*best, searched);
  }

  std::pair<std::vector<char>, std::vector<double>> markVertices(
    const Piece& piece, const ImprintedSurface& surface) const
  {
    std::vector<char> barred(surface.mesh.vertexCount(), 0);
    std::vector<double> worth(surface.mesh.vertexCount(), 1.0);
    for (const FeatureCurve& curve : surface.curves)
    {
      for (const SearchOptions::Preference& preference : this->Search.preferences)
      {
        for (Index v : curve.name == preference.curve ? curve.vertices : Indices{})
        {
          worth[v] = preference.weight;
        }
      }
      for (Index v : curve.type == CurveType::Key ? curve.vertices : Indices{})
      {
        barred[v] = 1;
      }
    }
    // Vertices of the cut surface come from those of the surface in the corners of its triangles.
    std::vector<char> barredHere(piece.mesh.vertexCount(), 0);
    std::vector<double> worthHere(piece.mesh.vertexCount(), 1.0);
    for (Index h = 0; h < piece.mesh.halfedgeCount(); ++h)
    {
      const Index v = surface.mesh.from(3 * piece.triangles[h / 3] + h % 3);
      barredHere[piece.mesh.from(h)] = barred[v];
      worthHere[piece.mesh.from(h)] = worth[v];
    }
    return { barredHere, worthHere };
  }

  bool accept(const TriedCut& best, const SearchedPiece& piece)
  {
    const double share = this->Now.valid ? best.score / this->Now.energy : 1.0;
    if (this->Search.bound > 0.0 && share * std::sqrt(this->Area / pi) < leastShare)
    {
      return false;
    }
    std::vector<SuggestedCurve> added;
    for (std::size_t k = 0; k < best.outcome.paths.size(); ++k)
    {
      SuggestedCurve cut;
      cut.curve.type = best.plan.type;
      cut.curve.points = best.outcome.paths[k];
      if (k == 1 && piece.mirrorIsExact())
      {
        cut.curve.points.clear();
        for (const Point3& p : best.outcome.paths[0])
        {
          cut.curve.points.push_back(piece.mirror()->mirrored(p));
        }
      }
      cut.length = best.outcome.lengths[k];
      cut.predictedGain = best.plan.predictedGain / this->Area;
      cut.opening = best.plan.opening;
      cut.mirrorOf = k == 1 ? static_cast<Index>(this->Result.cuts.size()) : none;
      added.push_back(cut);
    }
    std::vector<Polyline> cuts = this->chosen();
    for (const SuggestedCurve& cut : added)
    {
      cuts.push_back(cut.curve);
    }
    const TrialOutcome after = this->Whole.run(cuts, this->Run);
    --this->TrialsLeft;
    if (this->Now.valid ? !after.soundAfter(this->Now) : !after.valid)
    {
      return false;
    }
    for (SuggestedCurve& cut : added)
    {
      cut.strainBefore = this->Now.strainP95;
      cut.strainAfter = after.strainP95;
      cut.gain = (this->Now.energy - after.energy) / this->Area;
      this->Result.cuts.push_back(cut);
    }
    this->Now = after;
    return true;
  }

  const TriangleMesh& Mesh;
  const std::vector<Polyline>& Curves;
  const SuggestionOptions& Options;
  const SearchOptions& Search;
  const Execution& Run;
  CutTrials Whole;
  Index TrialsLeft;
  double Area = 0.0;
  std::size_t OpeningCount = 0; ///< the first cuts, which are needed whatever the bound
  TrialOutcome Now;
  CurveSuggestions Result;
};
}

CurveSuggestions suggestCurves(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SuggestionOptions& options, const Execution& execution)
{
  CurveSuggestions refused;
  refused.status = checkSearch(options.search, curves);
  if (!refused.status.ok())
  {
    return refused;
  }
  return withinMemory([&] { return Suggesting(mesh, curves, options, execution).run(); });
}
}
