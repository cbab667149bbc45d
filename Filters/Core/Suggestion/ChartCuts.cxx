// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/ChartCuts.h"

#include "Cut/SurfaceCut.h"
#include "Imprint/CurveImprint.h"
#include "Paths/PlaneSection.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/OpeningCuts.h"
#include "Suggestion/PieceSurface.h"
#include "Suggestion/SeamDrawing.h"
#include "Suggestion/SurfaceCoarsening.h"
#include "Suggestion/SurfaceMirror.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>

namespace flattening
{
namespace
{
/// Of the version that charts are found on.
constexpr Index chartTriangles = 4000;
/// Of the bound, the forecast strain of the first charts, which are merged afterwards.
constexpr double firstShare = 0.4;
/// Of the bound, what charts of the version with few triangles keep, so that those of the surface
/// itself keep it with seams that are drawn smooth, or with seams along its edges.
constexpr double coarseShare = 0.75;
constexpr double ruggedShare = 0.95;
/// Where a number of pieces is wanted, the search begins with the bound over this.
constexpr double finerBound = 8.0;
/// Of the bound of charts, that to which they are merged before their seams are drawn straight once
/// more.
constexpr double roughShare = 0.6;
/// Of the work for charts, what that may take.
constexpr double roughWork = 0.4;
/// Where seams are laid into the version with few triangles, see ImprintOptions: slivers are worse
/// than a seam that is not quite straight.
constexpr double workingSnap = 0.15;
/// On the surface itself: more than the default, so that what is far enough apart here is so there.
constexpr double surfaceSnap = 1e-2;
/// Of the budget, for charts on few triangles; the rest is for drawing seams on the surface.
constexpr double mergingShare = 0.5;
/// Of what is left then, for sewing seams from their ends on.
constexpr double sewingShare = 0.2;
/// Larger surfaces are parted on a version of half as many, to which their cuts are moved.
constexpr Index settledTriangles = 30000;
/// Seams are drawn anew this often at most.
constexpr int mostDrawings = 24;
/// Pieces with more strain than this many times the bound are parted again; darts do for others.
constexpr double partedShare = 1.5;
/// Of the work that is left then, what drawing them straighter may take.
constexpr double relaxingShare = 0.5;
/// Of the bound, up to where: the flattening to come may have a few triangles otherwise.
constexpr double relaxedShare = 0.95;
/// What drawing them takes, in steps of a flattening.
constexpr double drawingSteps = 5.0;
/// The flattening of a chart is given up after these steps; those of charts that keep the bound
/// take 55 at most with few triangles, and 126 beside the narrow triangles of seams that are drawn.
constexpr double mostChartSteps = 50.0;
constexpr double mostDrawnSteps = 130.0;
/// Charts are parted again this often at most.
constexpr int mostPartings = 3;
/// Where the mirror is worse than this, in sqrt(area / pi), cuts are tried from either side.
constexpr double unlikeSides = 0.01;
/// In snap distances of an imprint, how near points of the mirror plane's section are to it.
constexpr double inPlaneShare = 2.0;

/// With few triangles; creases stay.
TriangleMesh fewTriangles(const TriangleMesh& mesh, Index most)
{
  std::vector<char> kept(mesh.vertexCount(), 0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    kept[mesh.from(h)] = kept[mesh.from(h)] || isCrease(mesh, h) ? 1 : 0;
  }
  if (2 * std::count(kept.begin(), kept.end(), 1) > mesh.vertexCount())
  {
    kept.assign(kept.size(), 0); // those of a scan
  }
  return coarsened(mesh, std::move(kept), most).mesh;
}

Indices numbersTo(Index count)
{
  Indices numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// A mesh with cut edges.
struct CutMesh
{
  TriangleMesh mesh;
  std::vector<char> cut; ///< by half-edge
  Indices images;        ///< by half-edge
};

/// The cut edges between charts of few triangles each.
std::vector<char> firstCuts(const TriangleMesh& mesh, double bound)
{
  const std::vector<Indices> loops = mesh.boundaryLoops();
  const Indices chart = clusterTriangles(mesh, loops, findHoles(mesh, loops), bound);
  std::vector<char> cut(mesh.halfedgeCount(), 0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    const Index twin = mesh.twin(h);
    cut[h] = twin != none && chart[h / 3] != chart[twin / 3] ? 1 : 0;
  }
  return cut;
}

/// Sets of lines that cannot be laid into a surface together.
std::vector<Indices> failingLines(const ImprintedSurface& imprinted, std::size_t count)
{
  if (imprinted.status.ok())
  {
    return meetingCurves(imprinted);
  }
  if (imprinted.status.curve != none)
  {
    return { { imprinted.status.curve } };
  }
  std::vector<Indices> bad;
  for (Index k = 0; k < static_cast<Index>(count); ++k)
  {
    bad.push_back({ k });
  }
  return bad;
}

/// The mesh cut along imprinted curves.
CutMesh cutAlong(const ImprintedSurface& imprinted)
{
  CutMesh result;
  result.mesh = imprinted.mesh;
  result.cut.assign(result.mesh.halfedgeCount(), 0);
  for (const FeatureCurve& curve : imprinted.curves)
  {
    for (std::size_t k = 1; k < curve.vertices.size(); ++k)
    {
      const Index h = result.mesh.find(curve.vertices[k - 1], curve.vertices[k]);
      const Index twin = h == none ? none : result.mesh.twin(h);
      if (twin != none)
      {
        result.cut[h] = result.cut[twin] = 1;
      }
    }
  }
  return result;
}

/// Each curve beside a triangle whose chart does not keep the bound.
std::vector<Indices> curvesBeside(const ImprintedSurface& surface, const std::vector<char>& keeping)
{
  std::vector<Indices> sets;
  for (std::size_t c = 0; c < surface.curves.size(); ++c)
  {
    const Indices& vertices = surface.curves[c].vertices;
    bool bad = false;
    for (std::size_t k = 1; k < vertices.size(); ++k)
    {
      for (Index h : { surface.mesh.find(vertices[k - 1], vertices[k]),
             surface.mesh.find(vertices[k], vertices[k - 1]) })
      {
        bad = bad || (h != none && !keeping[h / 3]);
      }
    }
    if (bad)
    {
      sets.push_back({ static_cast<Index>(c) });
    }
  }
  return sets;
}

/// The mesh cut along straight lines from end to end of its arcs, or as straight as they do not
/// meet and charts keep the bound.
CutMesh straightened(const TriangleMesh& mesh, const std::vector<Charts::Arc>& arcs,
  const ChartOptions& options, double size, ChartTrials& trials, TrialBudget& budget,
  const Execution& execution)
{
  const SeamDrawing drawing(mesh);
  const Indices numbers = numbersTo(static_cast<Index>(arcs.size()));
  std::vector<int> levels(arcs.size(), 0);
  std::vector<int> drawn(arcs.size(), -1);
  std::vector<Polyline> lines(arcs.size());
  CutMesh best;
  for (bool changed = true; changed;)
  {
    for (std::size_t k = 0; k < arcs.size(); ++k)
    {
      if (drawn[k] != levels[k])
      {
        std::vector<SurfacePoint> chain;
        for (Index v : arcs[k].vertices)
        {
          chain.push_back(vertexPoint(mesh, v));
        }
        lines[k].type = CurveType::Seam;
        lines[k].points = drawing.draw(chain, levels[k]);
        drawn[k] = levels[k];
      }
    }
    ImprintOptions imprint;
    imprint.snap = workingSnap;
    const ImprintedSurface imprinted = imprintCurves(mesh, lines, imprint);
    budget.pay(drawingSteps * static_cast<double>(mesh.triangleCount()));
    std::vector<Indices> bad = failingLines(imprinted, lines.size());
    if (bad.empty())
    {
      best = cutAlong(imprinted);
      Charts charts(
        best.mesh, best.cut, numbersTo(best.mesh.halfedgeCount()), options, size, trials);
      bad = curvesBeside(imprinted, charts.keeping(budget, execution));
    }
    changed = !budget.spent() && !execution.cancelled() && raiseLevels(bad, numbers, levels);
  }
  if (best.mesh.triangleCount() > 0)
  {
    return best;
  }
  best.mesh = mesh;
  best.cut.assign(mesh.halfedgeCount(), 0);
  for (const Charts::Arc& arc : arcs)
  {
    for (Index h : arc.edges)
    {
      best.cut[h] = best.cut[mesh.twin(h)] = 1;
    }
  }
  return best;
}

/// Two seams, no others of which meet where they do, are one.
std::vector<SuggestedCurve> joined(std::vector<SuggestedCurve> cuts)
{
  const auto alone = [&](std::size_t k) {
    return cuts[k].mirrorOf == none &&
      std::none_of(cuts.begin(), cuts.end(),
        [&](const SuggestedCurve& cut) { return cut.mirrorOf == static_cast<Index>(k); });
  };
  const auto together = [&](std::size_t a, std::size_t b) {
    return cuts[b].mirrorOf == static_cast<Index>(a) || (alone(a) && alone(b));
  };
  const auto meeting = [&](const Point3& point) {
    std::ptrdiff_t ends = 0;
    for (const SuggestedCurve& cut : cuts)
    {
      ends += (cut.curve.points.front() == point) + (cut.curve.points.back() == point);
    }
    return ends;
  };
  for (std::size_t a = 0; a < cuts.size(); ++a)
  {
    for (std::size_t b = a + 1; b < cuts.size(); ++b)
    {
      if (cuts[a].curve.type != CurveType::Seam || cuts[b].curve.type != CurveType::Seam ||
        !together(a, b))
      {
        continue;
      }
      Points3 first = cuts[a].curve.points;
      Points3 second = cuts[b].curve.points;
      const auto meet = [&] {
        return first.back() == second.front() && meeting(first.back()) == 2;
      };
      for (int way = 0; way < 4 && !meet(); ++way)
      {
        Points3& turned = way % 2 == 0 ? first : second;
        std::reverse(turned.begin(), turned.end());
      }
      if (!meet())
      {
        continue;
      }
      first.insert(first.end(), second.begin() + 1, second.end());
      cuts[a].curve.points = std::move(first);
      cuts[a].length += cuts[b].length;
      cuts.erase(cuts.begin() + static_cast<std::ptrdiff_t>(b));
      for (SuggestedCurve& cut : cuts)
      {
        cut.mirrorOf -= cut.mirrorOf > static_cast<Index>(b) ? 1 : 0;
      }
      --a; // it may be joined to others
      break;
    }
  }
  return cuts;
}

/// The pieces of a surface with its cuts, and what they are like flat.
struct DrawnPieces
{
  CutSurface cut;
  std::vector<Piece> pieces;
  std::vector<ChartTrials::Result> results;

  DrawnPieces(const ImprintedSurface& surface, ChartTrials& trials, TrialBudget& budget,
    const Execution& execution)
    : cut(cutSurface(surface.mesh, surface.curves))
    , pieces(extractPieces(this->cut))
  {
    std::vector<std::vector<TriangleMesh>> meshes;
    for (const Piece& piece : this->pieces)
    {
      meshes.push_back({ piece.mesh });
    }
    this->results = trials.run(meshes, std::numeric_limits<double>::infinity(), budget, execution);
  }

  /// How much is wrong with one: its strain, and one more where it is folded, lies over itself, or
  /// has no flattening.
  double fault(std::size_t piece) const
  {
    const ChartTrials::Result& result = this->results[piece];
    return (result.sound ? 0.0 : 1.0) + (std::isinf(result.strain) ? 0.0 : result.strain);
  }

  /// How many are wrong, and the largest strain.
  double worst() const
  {
    double count = 0.0;
    double strain = 0.0;
    for (const ChartTrials::Result& result : this->results)
    {
      count += result.sound ? 0.0 : 1.0;
      strain = std::max(strain, std::isinf(result.strain) ? 0.0 : result.strain);
    }
    return count + strain;
  }
};

/// Each dart that has different pieces at its sides.
std::vector<Indices> dividingDarts(const CutSurface& cut, const std::vector<SuggestedCurve>& cuts)
{
  std::vector<std::set<Index>> beside(cuts.size());
  for (Index h = 0; h < cut.mesh.halfedgeCount(); ++h)
  {
    if (cut.curveOfHalfedge[h] != none)
    {
      beside[cut.curveOfHalfedge[h]].insert(cut.pieceOfTriangle[h / 3]);
    }
  }
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

class ChartSearch
{
public:
  /// \param straight whether seams are drawn straight before charts are merged; otherwise charts that
  /// keep the bound on few triangles keep it on as many
  ChartSearch(const TriangleMesh& mesh, const std::optional<SymmetryPlane>& plane, bool straight,
    const ChartOptions& options, TrialBudget& budget, const Execution& execution)
    : Surface(mesh)
    , Plane(plane)
    , Straight(straight)
    , Options(options)
    , Bound(options.bound)
    , Budget(budget)
    , Run(execution)
    , Size(std::sqrt(mesh.area() / pi))
    , InPlane(inPlaneShare * SnapDistance(mesh, ImprintOptions().snap).greatest())
    , Trials(roughly(options.flattening), mostChartSteps)
  {
    this->Options.bound *= straight ? coarseShare : ruggedShare;
    this->Options.bound /= options.pieces > 0 ? finerBound : 1.0;
  }

  std::vector<SuggestedCurve> run()
  {
    const TriangleMesh half =
      fewTriangles(this->side(), this->Plane ? chartTriangles / 2 : chartTriangles);
    if (half.triangleCount() == 0 || this->Budget.spent())
    {
      return {};
    }
    Charts first(half, firstCuts(half, firstShare * this->Options.bound),
      numbersTo(half.halfedgeCount()), this->Options, this->Size, this->Trials);
    TrialBudget budget(mergingShare * this->Budget.left());
    first.divide(budget, this->Run);
    CutMesh parted{ half, first.cut(), {} };
    if (this->Straight)
    {
      const auto straighten = [&](const TriangleMesh& mesh, const std::vector<Charts::Arc>& arcs) {
        return straightened(mesh, arcs, this->Options, this->Size, this->Trials, budget, this->Run);
      };
      parted = straighten(half, first.arcs());
      ChartOptions rough = this->Options;
      rough.bound *= roughShare;
      rough.pieces = this->Plane ? (rough.pieces + 1) / 2 : rough.pieces;
      Charts merged(parted.mesh, parted.cut, numbersTo(parted.mesh.halfedgeCount()), rough,
        this->Size, this->Trials);
      TrialBudget some(roughWork * budget.left());
      merged.divide(some, this->Run);
      merged.merge(true, some, this->Run);
      budget.add(some);
      parted = straighten(parted.mesh, merged.arcs());
    }
    const CutMesh whole = this->withMirrored(parted);
    if (whole.mesh.triangleCount() == 0)
    {
      return {};
    }
    Charts charts(whole.mesh, whole.cut, whole.images, this->Options, this->Size, this->Trials);
    charts.divide(budget, this->Run);
    if (this->Options.pieces > 0)
    {
      const double reached = charts.mergeToFewest(budget, this->Run);
      this->Bound = std::max(this->Bound, reached / coarseShare);
    }
    else
    {
      charts.merge(false, budget, this->Run);
    }
    this->Budget.add(budget);
    if (this->Options.darts)
    {
      TrialBudget sewing(sewingShare * this->Budget.left());
      charts.shorten(sewing, this->Run);
      this->Budget.add(sewing);
    }
    this->settle(
      this->seams(whole.mesh, parted.mesh.vertexCount(), charts.arcs(this->Plane.has_value())));
    return joined(std::move(this->Best));
  }

  /// How many pieces are folded, or lie over themselves, and the largest strain.
  double worst() const { return this->Worst; }
  /// Whether it is far from what it was to reach.
  bool fails() const { return this->excess() > 0 || this->Worst > partedShare * this->Bound; }
  /// Whether its cuts are better than another's: fewer pieces beyond the number that is wanted;
  /// then within the bound, or nearer to it; then fewer.
  bool betterThan(const ChartSearch& other, double bound) const
  {
    const auto merit = [bound](const ChartSearch& search) {
      const bool counted = search.Options.pieces > 0;
      return std::tuple(
        search.excess(), counted ? search.Worst : std::max(search.Worst, bound), search.BestCuts);
    };
    return merit(*this) < merit(other);
  }

private:
  Index excess() const
  {
    return this->Options.pieces > 0 ? std::max<Index>(0, this->BestPieces - this->Options.pieces)
                                    : 0;
  }

  /// A seam or dart to be drawn, the first of each pair of images.
  struct Seam
  {
    Points3 chain;
    bool dart = false;
    bool crosses = false; ///< the mirror plane, in which the chain ends
    bool paired = false;
    int least = 0;  ///< level, that of a straight line where there is one
    int level = 0;  ///< of SeamDrawing
    Points3 points; ///< none: to be drawn
    Points3 image;
  };

  /// The surface on one side of the plane, if there is one.
  TriangleMesh side()
  {
    if (!this->Plane)
    {
      return this->Surface;
    }
    std::vector<Polyline> seams;
    for (const PlaneSection& section :
      planeSections(this->Surface, this->Plane->offset * this->Plane->normal, this->Plane->normal))
    {
      Polyline seam;
      seam.type = CurveType::Seam;
      for (const SurfacePoint& point : section.path.points)
      {
        seam.points.push_back(point.position);
      }
      seams.push_back(std::move(seam));
    }
    ImprintedSurface imprinted = imprintCurves(this->Surface, seams, {});
    if (seams.empty() || !imprinted.status.ok())
    {
      return {};
    }
    const CutSurface cut = cutSurface(imprinted.mesh, imprinted.curves);
    this->Surface = std::move(imprinted.mesh);
    std::vector<double> side(cut.pieceCount, 0.0);
    std::vector<char> open(cut.mesh.halfedgeCount(), 0);
    for (Index h = 0; h < cut.mesh.halfedgeCount(); ++h)
    {
      open[h] = cut.mesh.twin(h) == none ? 1 : 0;
      side[cut.pieceOfTriangle[h / 3]] +=
        cut.mesh.area(h / 3) * this->Plane->side(cut.mesh.point(cut.mesh.from(h)));
    }
    Indices triangles;
    for (Index t = 0; t < cut.mesh.triangleCount(); ++t)
    {
      if (side[cut.pieceOfTriangle[t]] > 0.0)
      {
        triangles.push_back(t);
      }
    }
    return openedPart(this->Surface, triangles, open).mesh;
  }

  bool inPlane(const Point3& point) const
  {
    return this->Plane && std::abs(this->Plane->side(point)) < this->InPlane;
  }

  /// Both sides of the plane together, cut along it as well. Empty where edges inside lie in it.
  CutMesh withMirrored(const CutMesh& half) const
  {
    CutMesh whole = half;
    const Index count = half.mesh.halfedgeCount();
    whole.images = numbersTo(count);
    if (!this->Plane)
    {
      return whole;
    }
    Points3 points = half.mesh.points();
    Indices image;
    for (Index v = 0; v < half.mesh.vertexCount(); ++v)
    {
      const bool shared = half.mesh.onBoundary(v) && this->inPlane(points[v]);
      image.push_back(shared ? v : static_cast<Index>(points.size()));
      if (!shared)
      {
        points.push_back(this->Plane->mirrored(points[v]));
      }
    }
    for (Index h = 0; h < count; ++h)
    {
      if (half.mesh.twin(h) != none && image[half.mesh.from(h)] == half.mesh.from(h) &&
        image[half.mesh.to(h)] == half.mesh.to(h))
      {
        return {}; // four triangles would meet at the edge
      }
    }
    Triangles cells = half.mesh.triangles();
    for (const auto& [a, b, c] : half.mesh.triangles())
    {
      cells.push_back({ image[a], image[c], image[b] });
    }
    whole.mesh = TriangleMesh(std::move(points), std::move(cells));
    whole.cut.resize(2 * count);
    whole.images.resize(2 * count);
    for (Index h = 0; h < count; ++h)
    {
      const Index other = count + h / 3 * 3 + 2 - h % 3;
      whole.cut[h] = whole.cut[other] = half.cut[h] || whole.mesh.twin(h) == other ? 1 : 0;
      whole.images[h] = other;
      whole.images[other] = h;
    }
    return whole;
  }

  /// \param half how many vertices are on one side of the plane
  std::vector<Seam> seams(
    const TriangleMesh& mesh, Index half, const std::vector<Charts::Arc>& arcs) const
  {
    std::vector<Seam> seams;
    for (bool darts : { false, true })
    {
      for (const Charts::Arc& arc : arcs)
      {
        Seam seam;
        seam.dart = arc.dart;
        bool inside = false;
        for (Index v : arc.vertices)
        {
          if (v < half)
          {
            seam.chain.push_back(mesh.point(v));
            inside = inside || !this->inPlane(mesh.point(v));
          }
        }
        seam.crosses = seam.chain.size() < arc.vertices.size();
        if (arc.dart != darts || (seam.crosses && !inside))
        {
          continue; // an image
        }
        if (seam.crosses && arc.vertices.front() >= half)
        {
          std::reverse(seam.chain.begin(), seam.chain.end());
        }
        seam.paired = this->Plane && !seam.crosses && inside;
        const bool closed = arc.vertices.front() == arc.vertices.back();
        seam.least = seam.level = !inside ? SeamDrawing::levels - 1 : closed ? 1 : 0;
        seams.push_back(std::move(seam));
      }
    }
    return seams;
  }

  /// What seams are drawn with on the surface.
  struct Settling
  {
    SeamDrawing drawing;
    ImprintOptions imprint;
    ChartTrials trials;
  };

  /// Seams as they are drawn at some levels, and what they do.
  struct Drawn
  {
    std::vector<SuggestedCurve> cuts;
    Indices seamOf;           ///< by cut
    std::vector<Indices> bad; ///< sets of cuts that meet, or each beside a piece that fails
    bool laid = false;        ///< whether they can be laid into the surface
    Index pieces = 0;
    double worst = std::numeric_limits<double>::infinity();
  };

  Drawn drawn(Settling& settling, const std::vector<int>& levels, std::vector<Seam>& seams) const
  {
    Drawn result;
    this->draw(settling.drawing, levels, seams);
    this->Budget.pay(drawingSteps * static_cast<double>(this->Surface.triangleCount()));
    result.cuts = cutsOf(seams, result.seamOf);
    const std::vector<Polyline> lines = linesOf(result.cuts);
    const ImprintedSurface imprinted = imprintCurves(this->Surface, lines, settling.imprint);
    result.bad = failingLines(imprinted, lines.size());
    if (result.bad.empty())
    {
      result.bad = dividingDarts(cutSurface(imprinted.mesh, imprinted.curves), result.cuts);
    }
    result.laid = result.bad.empty();
    if (result.laid)
    {
      const DrawnPieces pieces(imprinted, settling.trials, this->Budget, this->Run);
      result.bad = this->aroundBad(pieces, lines.size());
      result.pieces = static_cast<Index>(pieces.pieces.size());
      if (!this->Run.cancelled() && !this->Budget.spent())
      {
        result.worst = pieces.worst();
      }
    }
    return result;
  }

  void keep(const Drawn& drawn)
  {
    this->Best = drawn.cuts;
    this->BestCuts = drawn.cuts.size();
    this->BestPieces = drawn.pieces;
    this->Worst = drawn.worst;
  }

  /// As straight as charts that keep the bound and cuts that do not meet allow.
  void settle(std::vector<Seam> seams)
  {
    ImprintOptions imprint;
    imprint.snap = surfaceSnap;
    Settling settling{ SeamDrawing(this->Surface), imprint,
      ChartTrials(this->Options.flattening, mostDrawnSteps) };
    std::vector<int> levels;
    for (const Seam& seam : seams)
    {
      levels.push_back(seam.level);
    }
    bool changed = true;
    for (int k = 0; k <= mostDrawings && changed && !this->Run.cancelled() && !this->Budget.spent();
         ++k)
    {
      if (k == mostDrawings && this->Best.empty())
      {
        levels.assign(levels.size(), SeamDrawing::levels - 1);
      }
      const Drawn now = this->drawn(settling, levels, seams);
      if (now.worst < this->Worst)
      {
        this->keep(now);
      }
      changed = raiseLevels(now.bad, now.seamOf, levels);
      if (!changed && !now.laid)
      {
        // What cannot be drawn in any way is left out: of seams on each other the shortest.
        changed = this->leaveOut(now.bad.front(), now.seamOf, now.cuts, seams, levels);
      }
      if (now.bad.empty() && now.worst <= this->Worst)
      {
        this->relax(settling, std::move(levels), std::move(seams));
        return;
      }
    }
  }

  /// Draws seams straighter that were drawn anew beside others, where charts still keep the bound,
  /// the longest first.
  void relax(Settling& settling, std::vector<int> levels, std::vector<Seam> seams)
  {
    const double end = this->Budget.left() * (1.0 - relaxingShare);
    const double most = std::max(this->Worst, relaxedShare * this->Bound);
    Indices order = numbersTo(static_cast<Index>(seams.size()));
    std::stable_sort(order.begin(), order.end(),
      [&seams](Index a, Index b) { return lengthOf(seams[a].points) > lengthOf(seams[b].points); });
    for (Index s : order)
    {
      const int before = levels[s];
      for (int level = seams[s].least; level < before && levels[s] == before; ++level)
      {
        if (this->Run.cancelled() || this->Budget.left() < end)
        {
          return;
        }
        levels[s] = level;
        const Drawn now = this->drawn(settling, levels, seams);
        if (now.bad.empty() && now.worst <= most)
        {
          this->keep(now);
          break;
        }
        levels[s] = before;
      }
    }
  }

  /// The shortest of the cuts, and its image.
  bool leaveOut(const Indices& set, const Indices& seamOf, const std::vector<SuggestedCurve>& cuts,
    std::vector<Seam>& seams, std::vector<int>& levels) const
  {
    const Index shortest = *std::min_element(
      set.begin(), set.end(), [&](Index a, Index b) { return cuts[a].length < cuts[b].length; });
    seams.erase(seams.begin() + seamOf[shortest]);
    levels.erase(levels.begin() + seamOf[shortest]);
    return !seams.empty();
  }

  void draw(
    const SeamDrawing& drawing, const std::vector<int>& levels, std::vector<Seam>& seams) const
  {
    for (std::size_t s = 0; s < seams.size(); ++s)
    {
      Seam& seam = seams[s];
      if (!seam.points.empty() && seam.level == levels[s])
      {
        continue;
      }
      seam.level = levels[s];
      std::vector<SurfacePoint> chain;
      std::vector<SurfacePoint> image;
      for (const Point3& point : seam.chain)
      {
        chain.push_back(drawing.place(point));
        if (seam.paired || seam.crosses)
        {
          image.push_back(
            this->inPlane(point) ? chain.back() : drawing.place(this->Plane->mirrored(point)));
        }
      }
      seam.points = drawing.draw(chain, seam.level);
      seam.image.clear();
      if (image.empty())
      {
        continue;
      }
      if (this->Plane->error > SurfaceMirror::exact)
      {
        seam.image = drawing.draw(image, seam.level);
        continue;
      }
      for (const Point3& point : seam.points)
      {
        seam.image.push_back(this->inPlane(point) ? point : this->Plane->mirrored(point));
      }
    }
  }

  /// The seams and their images.
  static std::vector<SuggestedCurve> cutsOf(const std::vector<Seam>& seams, Indices& seamOf)
  {
    std::vector<SuggestedCurve> cuts;
    const auto add = [&](Points3 points, std::size_t s, Index mirrorOf) {
      SuggestedCurve cut;
      cut.curve.type = seams[s].dart ? CurveType::Dart : CurveType::Seam;
      cut.length = lengthOf(points);
      cut.curve.points = std::move(points);
      cut.mirrorOf = mirrorOf;
      cuts.push_back(std::move(cut));
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

  /// Each curve that bounds a piece which does not keep the bound.
  std::vector<Indices> aroundBad(const DrawnPieces& pieces, std::size_t curves) const
  {
    std::vector<char> bad(curves, 0);
    for (Index h = 0; h < pieces.cut.mesh.halfedgeCount(); ++h)
    {
      const Index curve = pieces.cut.curveOfHalfedge[h];
      if (curve != none && !pieces.results[pieces.cut.pieceOfTriangle[h / 3]].keeps(this->Bound))
      {
        bad[curve] = 1;
      }
    }
    std::vector<Indices> sets;
    for (std::size_t k = 0; k < bad.size(); ++k)
    {
      if (bad[k])
      {
        sets.push_back({ static_cast<Index>(k) });
      }
    }
    return sets;
  }

  TriangleMesh Surface; ///< with the section of the plane
  std::optional<SymmetryPlane> Plane;
  bool Straight;
  ChartOptions Options; ///< on few triangles
  double Bound;
  TrialBudget& Budget;
  const Execution& Run;
  double Size;        ///< sqrt(area / pi)
  double InPlane;     ///< the distance within which points are
  ChartTrials Trials; ///< on few triangles
  std::vector<SuggestedCurve> Best;
  std::size_t BestCuts = 0;
  Index BestPieces = 0;
  double Worst = std::numeric_limits<double>::infinity(); ///< of the best
};

/// The cuts of a version with fewer triangles on the surface itself.
std::vector<SuggestedCurve> drawnOn(const TriangleMesh& mesh,
  const std::optional<SymmetryPlane>& plane, std::vector<SuggestedCurve> cuts)
{
  const SeamDrawing drawing(mesh);
  const bool exact = plane && plane->error <= SurfaceMirror::exact;
  for (SuggestedCurve& cut : cuts)
  {
    Points3& points = cut.curve.points;
    if (exact && cut.mirrorOf != none)
    {
      points = cuts[cut.mirrorOf].curve.points;
      for (Point3& point : points)
      {
        point = plane->mirrored(point);
      }
      continue;
    }
    std::vector<SurfacePoint> chain;
    for (const Point3& point : points)
    {
      chain.push_back(drawing.place(point));
    }
    points = drawing.draw(chain, SeamDrawing::levels - 1);
    cut.length = lengthOf(points);
  }
  return cuts;
}

/// Adds cuts in the pieces that do not keep the bound yet. False where there are none.
bool addCuts(const TriangleMesh& mesh, const std::optional<SurfaceMirror>& mirror, bool straight,
  const ChartOptions& options, std::vector<SuggestedCurve>& cuts, ChartTrials& trials,
  TrialBudget& budget, const Execution& execution)
{
  const ImprintedSurface surface = imprintCurves(mesh, linesOf(cuts), {});
  if (!surface.status.ok())
  {
    return false;
  }
  const DrawnPieces drawn(surface, trials, budget, execution);
  const std::vector<Piece>& pieces = drawn.pieces;
  const Indices images =
    pieceImages(pieceSurfaces(surface, drawn.cut), mirror, std::sqrt(mesh.area() / pi));
  bool added = false;
  std::vector<char> done(pieces.size(), 0);
  for (std::size_t p = 0; p < pieces.size() && !budget.spent(); ++p)
  {
    if (done[p] || drawn.results[p].keeps(partedShare * options.bound))
    {
      continue;
    }
    std::vector<SuggestedCurve> more = cuts;
    ChartSearch search(pieces[p].mesh, std::nullopt, straight, options, budget, execution);
    const std::vector<SuggestedCurve> here = search.run();
    if (search.worst() >= drawn.fault(p))
    {
      continue;
    }
    more.insert(more.end(), here.begin(), here.end());
    if (images[p] != none)
    {
      done[images[p]] = 1;
      addImages(more, static_cast<Index>(cuts.size()), *mirror);
    }
    // Beside the others it may come too near to them.
    if (!here.empty() && !CutTrials(mesh, {}, {}, options.flattening).paths(linesOf(more)).empty())
    {
      cuts = std::move(more);
      added = true;
    }
  }
  return added;
}
}

std::vector<SuggestedCurve> chartCuts(const TriangleMesh& mesh,
  const std::optional<SymmetryPlane>& plane, const ChartOptions& options, TrialBudget& budget,
  const Execution& execution)
{
  if (mesh.triangleCount() > settledTriangles)
  {
    return drawnOn(mesh, plane,
      chartCuts(fewTriangles(mesh, settledTriangles / 2), plane, options, budget, execution));
  }
  ChartSearch first(mesh, plane, true, options, budget, execution);
  std::vector<SuggestedCurve> cuts = first.run();
  const ChartSearch* best = &first;
  std::optional<ChartSearch> second;
  if (plane && plane->error > unlikeSides)
  {
    second.emplace(mesh, SymmetryPlane{ -plane->normal, -plane->offset, plane->error }, true,
      options, budget, execution);
    std::vector<SuggestedCurve> others = second->run();
    if (second->betterThan(first, options.bound))
    {
      cuts = std::move(others);
      best = &*second;
    }
  }
  // Halves may differ too much for the cuts of one to do for the other.
  const bool unlike =
    plane && plane->error > SurfaceMirror::exact && !options.mirrorKept && best->fails();
  if (plane && (cuts.empty() || unlike))
  {
    return chartCuts(mesh, std::nullopt, options, budget, execution);
  }
  const std::optional<SurfaceMirror> mirror =
    plane ? std::optional<SurfaceMirror>(*plane) : std::nullopt;
  ChartTrials trials(options.flattening, mostDrawnSteps);
  const int partings = options.pieces > 0 ? 0 : mostPartings;
  for (int k = 0; k < partings && !cuts.empty() && !budget.spent(); ++k)
  {
    if (!addCuts(mesh, mirror, k == 0, options, cuts, trials, budget, execution) && k > 0)
    {
      break;
    }
  }
  return cuts;
}
}
