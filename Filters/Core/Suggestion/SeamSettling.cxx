// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SeamSettling.h"

#include "Imprint/CurveImprint.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/CutTrials.h"
#include "Suggestion/SeamDrawing.h"
#include "Suggestion/SurfaceMirror.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace flattening
{
namespace
{
/// Seams are drawn anew this often at most.
constexpr int maxDrawings = 24;
/// Of the work that is left then, what drawing them straighter may take.
constexpr double relaxingShare = 0.5;
/// Cuts that cannot be laid into a surface are changed this often at most.
constexpr int maxLayings = 50;
/// In distances of two places, the longest way between them on one layer of a surface.
constexpr double longestWay = 2.0;

/// By cut the pieces at its sides. \param first curve of the cuts
std::vector<std::set<Index>> piecesBeside(const CutSurface& cut, std::size_t cuts, Index first)
{
  std::vector<std::set<Index>> beside(cuts);
  for (Index h = 0; h < cut.mesh.halfedgeCount(); ++h)
  {
    if (cut.curveOfHalfedge[h] >= first)
    {
      beside[cut.curveOfHalfedge[h] - first].insert(cut.pieceOfTriangle[h / 3]);
    }
  }
  return beside;
}

/// Each dart that has different pieces at its sides. \param first curve of the cuts
std::vector<Indices> dividingDarts(
  const CutSurface& cut, const std::vector<SuggestedCurve>& cuts, Index first)
{
  const std::vector<std::set<Index>> beside = piecesBeside(cut, cuts.size(), first);
  std::vector<Indices> sets;
  for (std::size_t c = 0; c < cuts.size(); ++c)
  {
    if (cuts[c].curve.type == CurveType::Dart && beside[c].size() > 1)
    {
      sets.push_back({ static_cast<Index>(c) });
    }
  }
  return sets;
}

/// Without one cut and its image.
std::vector<SuggestedCurve> without(const std::vector<SuggestedCurve>& cuts, Index gone)
{
  return withShare(cuts, cuts[gone].mirrorOf == none ? gone : cuts[gone].mirrorOf, 0.0);
}

/// Each cut in the parts that are left of it where it runs along a curve or cut before it that
/// opens that stretch, or along the boundary. Those in parts have no images.
/// \param given curves of the surface before the cuts
std::vector<SuggestedCurve> unshared(
  const ImprintedSurface& surface, std::size_t given, const std::vector<SuggestedCurve>& cuts)
{
  const TriangleMesh& mesh = surface.mesh;
  std::vector<char> used(mesh.halfedgeCount(), 0);
  for (std::size_t c = 0; c < given; ++c)
  {
    if (surface.curves[c].opens())
    {
      forEachEdge(surface.curves[c].vertices, [&](Index a, Index b) {
        for (Index h : { mesh.find(a, b), mesh.find(b, a) })
        {
          if (h != none)
          {
            used[h] = 1;
          }
        }
      });
    }
  }
  std::vector<std::vector<Points3>> parts(cuts.size());
  for (std::size_t c = 0; c < cuts.size(); ++c)
  {
    bool going = false;
    forEachEdge(surface.curves[given + c].vertices, [&](Index a, Index b) {
      const Index h = mesh.find(a, b);
      const Index twin = h == none ? none : mesh.twin(h);
      const bool own = twin != none && !used[h];
      if (own && !going)
      {
        parts[c].push_back({ mesh.point(a) });
      }
      if (own)
      {
        parts[c].back().push_back(mesh.point(b));
        used[h] = used[twin] = 1;
      }
      going = own;
    });
  }
  std::vector<SuggestedCurve> left;
  Indices place(cuts.size(), none);
  const auto whole = [&](std::size_t c) {
    return parts[c].size() == 1 &&
      parts[c].front().size() == surface.curves[given + c].vertices.size();
  };
  for (std::size_t c = 0; c < cuts.size(); ++c)
  {
    if (whole(c))
    {
      place[c] = static_cast<Index>(left.size());
      left.push_back(cuts[c]);
      left.back().mirrorOf = cuts[c].mirrorOf == none ? none : place[cuts[c].mirrorOf];
      continue;
    }
    for (Points3& points : parts[c])
    {
      left.push_back(proposedCut(std::move(points), cuts[c].curve.type));
    }
  }
  return left;
}

class SeamSettling
{
public:
  SeamSettling(const TriangleMesh& surface, const TriangleMesh& drawn,
    const std::optional<MirrorSection>& mirror, double bound, double most,
    const FlatteningOptions& flattening, TrialBudget& budget, const Execution& execution)
    : Surface(surface)
    , Mirror(mirror)
    , Bound(bound)
    , Budget(budget)
    , Run(execution)
    , Drawing(drawn)
    , Trials(flattening, most)
  {
  }

  SettledSeams run(std::vector<ChartSeam> seams)
  {
    std::vector<int> levels;
    for (const ChartSeam& seam : seams)
    {
      levels.push_back(seam.level);
    }
    bool changed = true;
    // Where the run is cancelled a drawing along the chains is better than none.
    const auto going = [this] {
      return this->Run.cancelled() ? this->Best.cuts.empty() : !this->Budget.spent();
    };
    for (int k = 0; k <= maxDrawings && changed && going(); ++k)
    {
      const bool cancelled = this->Run.cancelled();
      if ((k == maxDrawings || cancelled) && this->Best.cuts.empty())
      {
        levels.assign(levels.size(), SeamDrawing::levels - 1);
      }
      const Drawn now = this->drawn(levels, seams, this->Bound);
      if (now.worst < this->Best.worst || (now.laid && cancelled))
      {
        this->keep(now);
      }
      changed = raiseLevels(now.bad, now.seamOf, levels);
      if (!changed && !now.laid)
      {
        this->layTogether(now.cuts);
      }
      changed = changed || (this->Run.cancelled() && !cancelled);
      if (now.bad.empty() && now.worst <= this->Best.worst)
      {
        this->relax(std::move(levels), std::move(seams), now);
        break;
      }
    }
    return std::move(this->Best);
  }

private:
  /// Seams as they are drawn at some levels, and what they do.
  struct Drawn
  {
    std::vector<SuggestedCurve> cuts;
    Indices seamOf;           ///< by cut
    std::vector<Indices> bad; ///< sets of cuts that meet, or each beside a piece that fails
    bool laid = false;        ///< whether they can be laid into the surface
    std::vector<std::set<Index>> beside; ///< by seam the pieces at its sides, where they are laid
    Index pieces = 0;
    double worst = std::numeric_limits<double>::infinity();
  };

  /// \param bound that pieces are to keep
  Drawn drawn(const std::vector<int>& levels, std::vector<ChartSeam>& seams, double bound)
  {
    Drawn result;
    this->draw(levels, seams);
    this->Budget.pay(SeamDrawing::steps * static_cast<double>(this->Surface.triangleCount()));
    result.cuts = cutsOf(seams, result.seamOf);
    const std::vector<Polyline> lines = linesOf(result.cuts);
    const ImprintedSurface imprinted = imprintCurves(this->Surface, lines, {});
    result.bad = failingLines(imprinted, lines.size());
    if (!result.bad.empty())
    {
      return result;
    }
    CutSurface cut = cutSurface(imprinted.mesh, imprinted.curves);
    result.bad = dividingDarts(cut, result.cuts, 0);
    result.laid = result.bad.empty();
    result.pieces = cut.pieceCount;
    if (result.laid && !this->Run.cancelled())
    {
      const DrawnPieces pieces(std::move(cut), this->Trials, this->Budget, this->Run);
      const std::vector<std::set<Index>> beside = piecesBeside(pieces.cut, lines.size(), 0);
      result.bad = aroundBad(pieces.results, beside, bound);
      result.beside.resize(seams.size());
      for (std::size_t c = 0; c < beside.size(); ++c)
      {
        result.beside[result.seamOf[c]].insert(beside[c].begin(), beside[c].end());
      }
      if (!this->Run.cancelled() && !this->Budget.spent())
      {
        result.worst = pieces.worst();
      }
    }
    return result;
  }

  void keep(const Drawn& drawn) { this->Best = { drawn.cuts, drawn.pieces, drawn.worst }; }

  /// Draws seams straighter that were drawn anew beside others, where charts still keep the bound,
  /// the longest first; at once those that have no piece in common, so that each piece tells of
  /// one.
  /// \param now the drawing at the levels
  void relax(std::vector<int> levels, std::vector<ChartSeam> seams, const Drawn& now)
  {
    const double end = this->Budget.left() * (1.0 - relaxingShare);
    const double most = std::max(this->Best.worst, relaxedShare * this->Bound);
    Indices order(seams.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&seams](Index a, Index b) {
      return polylineLength(seams[a].points) > polylineLength(seams[b].points);
    });
    std::vector<int> next; // level to be tried, up to the seam's
    for (const ChartSeam& seam : seams)
    {
      next.push_back(seam.least);
    }
    std::vector<std::set<Index>> beside = now.beside;
    const auto going = [&] { return !this->Run.cancelled() && this->Budget.left() >= end; };
    for (bool left = true; left && going();)
    {
      Indices chosen;
      std::set<Index> taken;
      for (Index s : order)
      {
        const auto isTaken = [&taken](Index piece) { return taken.count(piece) > 0; };
        if (next[s] < levels[s] && std::none_of(beside[s].begin(), beside[s].end(), isTaken))
        {
          chosen.push_back(s);
          taken.insert(beside[s].begin(), beside[s].end());
        }
      }
      left = !chosen.empty();
      for (bool kept = false; !chosen.empty() && !kept && going();)
      {
        std::vector<int> tried = levels;
        for (Index s : chosen)
        {
          tried[s] = next[s];
        }
        const Drawn drawing = this->drawn(tried, seams, most);
        kept = drawing.bad.empty() && drawing.worst <= most;
        if (kept)
        {
          this->keep(drawing);
          levels = std::move(tried);
          beside = drawing.beside;
          continue;
        }
        std::set<Index> failed;
        for (const Indices& set : drawing.bad)
        {
          for (Index cut : set)
          {
            failed.insert(drawing.seamOf[cut]);
          }
        }
        // Where none of them is to blame, all are.
        const auto sound = [&failed](Index s) { return failed.count(s) == 0; };
        if (std::all_of(chosen.begin(), chosen.end(), sound))
        {
          failed.insert(chosen.begin(), chosen.end());
        }
        for (Index s : chosen)
        {
          next[s] += sound(s) ? 0 : 1;
        }
        eraseIf(chosen, [&sound](Index s) { return !sound(s); });
      }
    }
  }

  /// Seams that cannot be drawn apart are kept as they can be laid together.
  void layTogether(std::vector<SuggestedCurve> cuts)
  {
    Drawn laid;
    laid.cuts = laidTogether(this->Surface, std::move(cuts));
    if (laid.cuts.empty())
    {
      return;
    }
    const ImprintedSurface imprinted = imprintCurves(this->Surface, linesOf(laid.cuts), {});
    const DrawnPieces pieces(cutSurface(imprinted.mesh, imprinted.curves), this->Trials,
      this->Budget, this->Run.uninterrupted());
    laid.pieces = pieces.cut.pieceCount;
    laid.worst = pieces.worst();
    if (laid.worst < this->Best.worst)
    {
      this->keep(laid);
    }
  }

  void draw(const std::vector<int>& levels, std::vector<ChartSeam>& seams) const
  {
    for (std::size_t s = 0; s < seams.size(); ++s)
    {
      ChartSeam& seam = seams[s];
      if (!seam.points.empty() && seam.level == levels[s])
      {
        continue;
      }
      seam.level = levels[s];
      const std::vector<SurfacePoint> chain = this->Drawing.place(seam.chain);
      seam.points = this->Drawing.draw(chain, seam.level);
      seam.image.clear();
      if (!seam.paired && !seam.crosses)
      {
        continue;
      }
      if (this->Mirror->plane.error > SurfaceMirror::exact)
      {
        std::vector<SurfacePoint> image = this->Drawing.place(seam.imageChain);
        for (std::size_t k = 0; k < image.size(); ++k)
        {
          image[k] = this->Mirror->has(seam.chain[k]) ? chain[k] : image[k];
        }
        seam.image = this->Drawing.draw(this->withoutDetours(image), seam.level);
        continue;
      }
      for (const Point3& point : seam.points)
      {
        seam.image.push_back(
          this->Mirror->has(point) ? point : this->Mirror->plane.mirrored(point));
      }
    }
  }

  /// Without places to which the way is far longer than the distance: images on another layer.
  std::vector<SurfacePoint> withoutDetours(const std::vector<SurfacePoint>& chain) const
  {
    std::vector<SurfacePoint> kept{ chain.front() };
    for (std::size_t k = 1; k < chain.size(); ++k)
    {
      const double distance = (chain[k].position - kept.back().position).norm();
      const Points3 way = this->Drawing.draw({ kept.back(), chain[k] }, SeamDrawing::levels - 1);
      if (k + 1 == chain.size() || (!way.empty() && polylineLength(way) <= longestWay * distance))
      {
        kept.push_back(chain[k]);
      }
    }
    return kept;
  }

  /// The seams and their images.
  static std::vector<SuggestedCurve> cutsOf(const std::vector<ChartSeam>& seams, Indices& seamOf)
  {
    std::vector<SuggestedCurve> cuts;
    const auto add = [&](Points3 points, std::size_t s, Index mirrorOf) {
      const CurveType type = seams[s].dart ? CurveType::Dart : CurveType::Seam;
      cuts.push_back(proposedCut(std::move(points), type, mirrorOf));
      seamOf.push_back(static_cast<Index>(s));
    };
    for (std::size_t s = 0; s < seams.size(); ++s)
    {
      Points3 points = seams[s].points;
      const Points3& image = seams[s].image;
      if (seams[s].crosses)
      {
        points.insert(points.end(), image.rbegin() + 1, image.rend());
      }
      add(std::move(points), s, none);
      if (seams[s].paired)
      {
        add(image, s, static_cast<Index>(cuts.size()) - 1);
      }
    }
    return cuts;
  }

  /// Each cut that bounds a piece which does not keep a bound.
  static std::vector<Indices> aroundBad(const std::vector<ChartTrials::Result>& pieces,
    const std::vector<std::set<Index>>& beside, double bound)
  {
    std::vector<Indices> sets;
    for (std::size_t k = 0; k < beside.size(); ++k)
    {
      if (std::any_of(beside[k].begin(), beside[k].end(),
            [&](Index piece) { return !pieces[piece].keeps(bound); }))
      {
        sets.push_back({ static_cast<Index>(k) });
      }
    }
    return sets;
  }

  const TriangleMesh& Surface;
  const std::optional<MirrorSection>& Mirror;
  double Bound;
  TrialBudget& Budget;
  const Execution& Run;
  SeamDrawing Drawing;
  ChartTrials Trials;
  SettledSeams Best;
};
}

void openDividingDarts(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const ImprintOptions& imprint, std::vector<SuggestedCurve>& cuts)
{
  const auto isDart = [](const SuggestedCurve& cut) { return cut.curve.type == CurveType::Dart; };
  if (std::none_of(cuts.begin(), cuts.end(), isDart))
  {
    return;
  }
  const ImprintedSurface surface = imprintCurves(mesh, withLines(curves, linesOf(cuts)), imprint);
  if (surface.status.ok())
  {
    for (const Indices& dart : dividingDarts(
           cutSurface(surface.mesh, surface.curves), cuts, static_cast<Index>(curves.size())))
    {
      cuts[dart.front()].curve.type = CurveType::Seam;
    }
  }
  pairTypes(cuts);
}

std::vector<SuggestedCurve> laidTogether(const TriangleMesh& mesh, std::vector<SuggestedCurve> cuts,
  const std::vector<Polyline>& curves, const ImprintOptions& imprint)
{
  const CutTrials trials(mesh, curves, imprint, {});
  const auto given = static_cast<Index>(curves.size());
  for (int k = 0; k < maxLayings && !cuts.empty(); ++k)
  {
    const ImprintedSurface imprinted = trials.imprinted(linesOf(cuts));
    if (imprinted.status.ok())
    {
      return cuts;
    }
    if (imprinted.mesh.triangleCount() > 0)
    {
      cuts = unshared(imprinted, curves.size(), cuts);
      openDividingDarts(mesh, curves, imprint, cuts);
      continue;
    }
    const Index bad = imprinted.status.curve;
    cuts = bad < given ? std::vector<SuggestedCurve>{} : without(cuts, bad - given);
  }
  return {};
}

SettledSeams settleSeams(const TriangleMesh& surface, const TriangleMesh& drawn,
  const std::optional<MirrorSection>& mirror, std::vector<ChartSeam> seams, double bound,
  double most, const FlatteningOptions& flattening, TrialBudget& budget, const Execution& execution)
{
  return SeamSettling(surface, drawn, mirror, bound, most, flattening, budget, execution)
    .run(std::move(seams));
}
}
