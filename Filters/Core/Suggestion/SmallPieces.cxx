// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SmallPieces.h"

#include "Base/CompressedRows.h"
#include "Cut/SurfaceCut.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/ChartClusters.h"
#include "Suggestion/ChartTrials.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/SeamSettling.h"

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

class Joining
{
public:
  Joining(const TriangleMesh& mesh, std::vector<SuggestedCurve> cuts, double bound,
    const FlatteningOptions& flattening, TrialBudget& budget, const Execution& execution)
    : Cuts(std::move(cuts))
    , Surface(imprintCurves(mesh, linesOf(this->Cuts), {}))
    , Bound(relaxedShare * bound)
    , Budget(budget)
    , Run(execution)
    , Trials(flattening, maxDrawnSteps)
  {
  }

  std::vector<SuggestedCurve> run()
  {
    if (!this->Surface.status.ok())
    {
      return std::move(this->Cuts);
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
    for (auto k = static_cast<Index>(this->Cuts.size()) - 1; k >= 0; --k)
    {
      if (this->Gone.count(k) > 0)
      {
        this->Cuts = withShare(this->Cuts, k, 0.0);
      }
    }
    return std::move(this->Cuts);
  }

private:
  void start()
  {
    const CutSurface cut = cutSurface(this->Surface.mesh, this->Surface.curves);
    this->PieceOf = cut.pieceOfTriangle;
    this->CutOf = cut.curveOfHalfedge;
    this->Open.assign(cut.mesh.halfedgeCount(), 0);
    this->Areas.assign(cut.pieceCount, 0.0);
    for (Index h = 0; h < cut.mesh.halfedgeCount(); ++h)
    {
      this->Open[h] = cut.mesh.twin(h) == none ? 1 : 0;
      this->Areas[this->PieceOf[h / 3]] += h % 3 == 0 ? cut.mesh.area(h / 3) : 0.0;
    }
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

  /// Joins a piece with the neighbor along the longest seams with which it may be.
  void join(Index piece)
  {
    std::map<Index, std::map<Index, double>> lengths; // by neighbor and seam
    std::map<Index, double> all;
    for (Index h = 0; h < this->Surface.mesh.halfedgeCount(); ++h)
    {
      const Index twin = this->Surface.mesh.twin(h);
      const Index other = twin == none ? piece : this->PieceOf[twin / 3];
      if (this->PieceOf[h / 3] == piece && other != piece && this->CutOf[h] != none)
      {
        lengths[other][this->CutOf[h]] += this->Surface.mesh.length(h);
        all[other] += this->Surface.mesh.length(h);
      }
    }
    Indices neighbors;
    for (const auto& [neighbor, length] : all)
    {
      neighbors.push_back(neighbor);
    }
    std::stable_sort(
      neighbors.begin(), neighbors.end(), [&all](Index a, Index b) { return all[a] > all[b]; });
    for (Index neighbor : neighbors)
    {
      std::set<Index> seams;
      Index longest = none;
      for (const auto& [seam, length] : lengths[neighbor])
      {
        seams.insert(seam);
        longest = longest == none || length > lengths[neighbor][longest] ? seam : longest;
      }
      if (this->leaveOut(seams) || (seams.size() > 1 && this->leaveOut({ longest })))
      {
        return;
      }
    }
  }

  std::set<Index> withImages(std::set<Index> seams) const
  {
    for (std::size_t k = 0; k < this->Cuts.size(); ++k)
    {
      const Index first = this->Cuts[k].mirrorOf;
      if (first != none && seams.count(first) + seams.count(static_cast<Index>(k)) == 1)
      {
        seams.insert({ first, static_cast<Index>(k) });
      }
    }
    return seams;
  }

  /// Leaves out seams and their images if what they part keeps the bound together.
  bool leaveOut(std::set<Index> seams)
  {
    seams = this->withImages(std::move(seams));
    if (this->Budget.spent() || this->Run.cancelled())
    {
      return false;
    }
    JoinedSets sets(static_cast<Index>(this->Areas.size()));
    std::vector<char> open = this->Open;
    for (Index h = 0; h < this->Surface.mesh.halfedgeCount(); ++h)
    {
      const Index twin = this->Surface.mesh.twin(h);
      if (twin != none && this->CutOf[h] != none && seams.count(this->CutOf[h]) > 0)
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
    this->Gone.insert(seams.begin(), seams.end());
    this->Open = std::move(open);
    this->Areas = std::move(areas);
    for (Index& piece : this->PieceOf)
    {
      piece = sets.find(piece);
    }
    return true;
  }

  std::vector<SuggestedCurve> Cuts;
  ImprintedSurface Surface;
  double Bound;
  TrialBudget& Budget;
  const Execution& Run;
  ChartTrials Trials;
  Indices PieceOf;           ///< by triangle
  Indices CutOf;             ///< by half-edge
  std::vector<char> Open;    ///< by half-edge
  std::vector<double> Areas; ///< by piece; 0 where it was joined to another
  std::set<Index> Gone;      ///< cuts
};
}

CutSet withoutSmallPieces(CutSet set, const SearchSubject& subject, const CutTrials& whole,
  TrialBudget& budget, const Execution& execution)
{
  const double bound = subject.search.bound;
  if (!set.outcome.keeps(bound) || !subject.curves.empty() || !subject.weights.empty() ||
    subject.search.pieces > 0)
  {
    return set;
  }
  TrialBudget joining(shareOfJoining * budget.left(), budget);
  CutSet fewer = set;
  fewer.cuts = Joining(subject.mesh, set.cuts, bound, subject.flattening, joining, execution).run();
  if (fewer.cuts.size() == set.cuts.size())
  {
    return set;
  }
  fewer = withFolds(std::move(fewer), whole, 0, bound, budget, execution);
  fewer.cutsNeeded = static_cast<double>(fewer.cuts.size());
  return fewer.outcome.keeps(bound) ? fewer : set;
}
}
