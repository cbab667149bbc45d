// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SmallPieces.h"

#include "Base/CompressedRows.h"
#include "Cut/SurfaceCut.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/ChartClusters.h"
#include "Suggestion/ChartTrials.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/SeamSettling.h"
#include "Surface/SurfaceLocator.h"

#include <algorithm>
#include <map>
#include <set>

namespace flattening
{
namespace
{
/// Of the area of the surface, below which a piece is small.
constexpr double smallShare = 0.01;
/// Of the remaining work.
constexpr double shareOfJoining = 0.5;
/// How often the surface is flattened with joins at most, of which those that miss the bound are
/// taken back: of four surfaces that missed it three kept it the second time.
constexpr int maxRestorings = 3;

class Joining
{
public:
  Joining(const TriangleMesh& mesh, std::vector<SuggestedCurve> cuts, double bound,
    const FlatteningOptions& flattening, TrialBudget& budget, const Execution& execution)
    : Given(mesh)
    , Cuts(std::move(cuts))
    , Surface(imprintCurves(mesh, linesOf(this->Cuts), {}))
    , Bound(relaxedShare * bound)
    , Budget(budget)
    , Run(execution)
    , Trials(flattening, maxDrawnSteps)
  {
  }

  /// Empty where none can be joined.
  std::vector<SuggestedCurve> run()
  {
    if (!this->Surface.status.ok())
    {
      return {};
    }
    this->start();
    const double small = smallShare * this->Surface.mesh.area();
    for (Index piece : this->bySize(small))
    {
      if (this->Areas[piece] > 0.0 && this->Areas[piece] < small)
      {
        this->join(piece);
      }
    }
    return this->Gone.empty() ? std::vector<SuggestedCurve>() : this->left();
  }

  /// Without the joins in pieces that miss the bound after all: on the surface, which has no edges
  /// along what is gone, they lie differently. Empty where none are left.
  std::vector<SuggestedCurve> restored(
    const std::vector<SuggestedCurve>& cuts, const TrialOutcome& outcome, double bound)
  {
    const ImprintedSurface surface = imprintCurves(this->Given, linesOf(cuts), {});
    const CutSurface cut = cutSurface(surface.mesh, surface.curves);
    const SurfaceLocator locator(surface.mesh);
    std::set<Index> missed;
    for (Index h = 0; h < this->Surface.mesh.halfedgeCount(); ++h)
    {
      if (this->Gone.count(this->StretchOf[h]) > 0 && missed.count(this->StretchOf[h]) == 0)
      {
        const TriangleMesh& mesh = this->Surface.mesh;
        const Index at =
          locator.closest(0.5 * (mesh.point(mesh.from(h)) + mesh.point(mesh.to(h)))).triangle;
        if (!outcome.keeps(static_cast<std::size_t>(cut.pieceOfTriangle[at]), bound))
        {
          missed.insert(this->StretchOf[h]);
        }
      }
    }
    for (Index stretch : this->withImages(missed))
    {
      this->Gone.erase(stretch);
    }
    return this->Gone.empty() ? std::vector<SuggestedCurve>() : this->left();
  }

private:
  void start()
  {
    const CutSurface cut = cutSurface(this->Surface.mesh, this->Surface.curves);
    this->PieceOf = cut.pieceOfTriangle;
    this->Open.assign(cut.mesh.halfedgeCount(), 0);
    this->Areas.assign(cut.pieceCount, 0.0);
    for (Index h = 0; h < cut.mesh.halfedgeCount(); ++h)
    {
      this->Open[h] = cut.mesh.twin(h) == none ? 1 : 0;
      this->Areas[this->PieceOf[h / 3]] += h % 3 == 0 ? cut.mesh.area(h / 3) : 0.0;
    }
    const TriangleMesh& mesh = this->Surface.mesh;
    this->StretchOf.assign(mesh.halfedgeCount(), none);
    this->Stretches.resize(this->Cuts.size());
    Index count = 0;
    for (std::size_t c = 0; c < this->Cuts.size(); ++c)
    {
      std::pair<Index, Index> before(none, none);
      forEachEdge(this->Surface.curves[c].vertices, [&](Index a, Index b) {
        const Index h = mesh.find(a, b);
        const Index twin = mesh.twin(h);
        const auto beside = std::minmax({ this->PieceOf[h / 3], this->PieceOf[twin / 3] });
        if (beside != before)
        {
          this->Stretches[c].push_back(count++);
          before = beside;
        }
        this->StretchOf[h] = this->StretchOf[twin] = this->Stretches[c].back();
      });
    }
  }

  /// By stretch of a cut, whether it is gone; empty where none is.
  std::vector<char> goneOf(std::size_t cut) const
  {
    std::vector<char> gone;
    for (Index stretch : this->Stretches[cut])
    {
      gone.push_back(this->Gone.count(stretch) > 0 ? 1 : 0);
    }
    return std::count(gone.begin(), gone.end(), 1) > 0 ? gone : std::vector<char>();
  }

  /// The cuts, and each run of stretches that is left of one; images where the same is gone of
  /// both.
  std::vector<SuggestedCurve> left() const
  {
    const TriangleMesh& mesh = this->Surface.mesh;
    std::vector<SuggestedCurve> left;
    std::vector<std::size_t> places; // of the first run, by cut
    for (std::size_t c = 0; c < this->Cuts.size(); ++c)
    {
      const std::size_t first = left.size();
      const std::vector<char> gone = this->goneOf(c);
      const bool whole = gone.empty();
      bool going = false;
      forEachEdge(this->Surface.curves[c].vertices, [&](Index a, Index b) {
        const bool kept = this->Gone.count(this->StretchOf[mesh.find(a, b)]) == 0;
        if (kept && !going)
        {
          left.push_back(proposedCut({ mesh.point(a) }, this->Cuts[c].curve.type));
        }
        if (kept && !whole)
        {
          left.back().curve.points.push_back(mesh.point(b));
          left.back().length += mesh.length(mesh.find(a, b));
        }
        going = kept;
      });
      if (whole)
      {
        left.back() = this->Cuts[c];
      }
      places.push_back(first);
      const Index image = this->Cuts[c].mirrorOf;
      const bool alike = image != none && this->goneOf(image) == gone;
      for (std::size_t k = first; k < left.size(); ++k)
      {
        left[k].mirrorOf = alike ? static_cast<Index>(places[image] + (k - first)) : none;
      }
    }
    return left;
  }

  /// The pieces smaller than that, the smallest first.
  Indices bySize(double small) const
  {
    Indices order;
    for (std::size_t p = 0; p < this->Areas.size(); ++p)
    {
      if (this->Areas[p] < small)
      {
        order.push_back(static_cast<Index>(p));
      }
    }
    std::stable_sort(order.begin(), order.end(),
      [this](Index a, Index b) { return this->Areas[a] < this->Areas[b]; });
    return order;
  }

  /// Joins a piece with the neighbor along the longest stretches of seams with which it may be.
  void join(Index piece)
  {
    std::map<Index, std::set<Index>> stretches; // by neighbor
    std::map<Index, double> lengths;
    for (Index h = 0; h < this->Surface.mesh.halfedgeCount(); ++h)
    {
      const Index twin = this->Surface.mesh.twin(h);
      const Index other = twin == none ? piece : this->PieceOf[twin / 3];
      if (this->PieceOf[h / 3] == piece && other != piece && this->StretchOf[h] != none)
      {
        stretches[other].insert(this->StretchOf[h]);
        lengths[other] += this->Surface.mesh.length(h);
      }
    }
    Indices neighbors;
    for (const auto& [neighbor, length] : lengths)
    {
      neighbors.push_back(neighbor);
    }
    std::stable_sort(neighbors.begin(), neighbors.end(),
      [&lengths](Index a, Index b) { return lengths[a] > lengths[b]; });
    for (Index neighbor : neighbors)
    {
      if (this->leaveOut(this->withImages(stretches[neighbor])))
      {
        return;
      }
    }
  }

  std::set<Index> withImages(std::set<Index> stretches) const
  {
    const std::set<Index> given = stretches;
    for (std::size_t k = 0; k < this->Cuts.size(); ++k)
    {
      const Index image = this->Cuts[k].mirrorOf;
      const std::size_t count = this->Stretches[k].size();
      for (std::size_t s = 0; image != none && this->Stretches[image].size() == count && s < count;
           ++s)
      {
        const Index one = this->Stretches[k][s];
        const Index other = this->Stretches[image][s];
        if (given.count(one) + given.count(other) == 1)
        {
          stretches.insert({ one, other });
        }
      }
    }
    return stretches;
  }

  /// Leaves out stretches of seams if what they part keeps the bound together.
  bool leaveOut(const std::set<Index>& stretches)
  {
    if (this->Budget.spent() || this->Run.cancelled())
    {
      return false;
    }
    JoinedSets sets(static_cast<Index>(this->Areas.size()));
    std::vector<char> open = this->Open;
    for (Index h = 0; h < this->Surface.mesh.halfedgeCount(); ++h)
    {
      const Index twin = this->Surface.mesh.twin(h);
      if (twin != none && stretches.count(this->StretchOf[h]) > 0)
      {
        open[h] = 0;
        sets.join(this->PieceOf[h / 3], this->PieceOf[twin / 3]);
      }
    }
    std::map<Index, Indices> triangles; // by joined piece
    for (Index t = 0; t < this->Surface.mesh.triangleCount(); ++t)
    {
      triangles[sets.find(this->PieceOf[t])].push_back(t);
    }
    std::vector<std::vector<TriangleMesh>> joined(1);
    std::vector<double> areas(this->Areas.size(), 0.0);
    for (std::size_t p = 0; p < areas.size(); ++p)
    {
      areas[sets.find(static_cast<Index>(p))] += this->Areas[p];
    }
    for (const auto& [piece, cells] : triangles)
    {
      if (areas[piece] > this->Areas[piece])
      {
        joined.front().push_back(openedPart(this->Surface.mesh, cells, open).mesh);
      }
    }
    const ChartTrials::Result flat =
      this->Trials.run(joined, this->Bound, this->Budget, this->Run).front();
    if (!flat.keeps(this->Bound))
    {
      return false;
    }
    this->Gone.insert(stretches.begin(), stretches.end());
    this->Open = std::move(open);
    this->Areas = std::move(areas);
    for (Index& piece : this->PieceOf)
    {
      piece = sets.find(piece);
    }
    return true;
  }

  const TriangleMesh& Given;
  std::vector<SuggestedCurve> Cuts;
  ImprintedSurface Surface;
  double Bound;
  TrialBudget& Budget;
  const Execution& Run;
  ChartTrials Trials;
  Indices PieceOf; ///< by triangle
  /// By cut those that it has, one after the other: each parts the same two pieces all along.
  std::vector<Indices> Stretches;
  Indices StretchOf;         ///< by half-edge
  std::vector<char> Open;    ///< by half-edge
  std::vector<double> Areas; ///< by piece; 0 where it was joined to another
  std::set<Index> Gone;      ///< stretches
};
}

CutSet withoutSmallPieces(CutSet set, const SearchSubject& subject, const CutTrials& whole,
  TrialBudget& budget, const Execution& execution)
{
  const double bound = subject.search.bound;
  if (!set.outcome.valid || bound == 0.0 || !subject.curves.empty() || !subject.weights.empty() ||
    subject.search.pieces > 0)
  {
    return set;
  }
  TrialBudget some(shareOfJoining * budget.left(), budget);
  Joining joining(subject.mesh, set.cuts, bound, subject.flattening, some, execution);
  std::vector<SuggestedCurve> left = joining.run();
  for (int k = 0; k < maxRestorings && !left.empty(); ++k)
  {
    CutSet fewer = set;
    fewer.cuts = std::move(left);
    fewer = withFolds(std::move(fewer), whole, 0, bound, budget, execution);
    fewer.cutsNeeded = static_cast<double>(fewer.cuts.size());
    const TrialOutcome& outcome = fewer.outcome;
    if (!outcome.valid || !keepsLimits(fewer, subject.search))
    {
      return set; // seams in parts may be more
    }
    if (outcome.faults() <= set.outcome.faults() &&
      outcome.strainP95 <= std::max(bound, set.outcome.strainP95))
    {
      return fewer;
    }
    left = joining.restored(fewer.cuts, fewer.outcome, bound);
  }
  return set;
}
}
