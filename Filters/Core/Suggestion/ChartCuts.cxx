// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/ChartCuts.h"

#include "Cut/SurfaceCut.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/CutMesh.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/OpeningCuts.h"
#include "Suggestion/PieceSurface.h"
#include "Suggestion/SeamDrawing.h"
#include "Suggestion/SeamSettling.h"
#include "Suggestion/SeamTree.h"
#include "Suggestion/SurfaceCoarsening.h"
#include "Suggestion/SurfaceMirror.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
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
/// Of the budget, for charts on few triangles; the rest is for drawing seams on the surface.
constexpr double mergingShare = 0.5;
/// Of what is left then, for sewing seams from their ends on.
constexpr double sewingShare = 0.2;
/// The flattening of a chart is given up after these steps; those of charts that keep the bound
/// take 55 at most.
constexpr double maxChartSteps = 50.0;
/// Of the bound, the forecasts up to which the tree of one piece grows, one after the other: a free
/// boundary keeps far less strain than is forecast. Of the work, what that may take.
constexpr double firstForecast = 3.0;
constexpr double nextForecast = 0.9;
constexpr double lastForecast = 0.3;
/// The forecast is lowered by a power of what the strain is too much, found from the last two with
/// at least this logarithm between them, at least this one, but to no less than a share at once: of
/// three trees it went with the strain's power of 0.7 to 3.
constexpr double leastFall = 0.01;
constexpr double leastPower = 0.8;
constexpr double leastStep = 0.5;
constexpr double growingShare = 0.6;
/// Without overlap three statues took up to 360 steps on 4,000 to 5,100 triangles.
constexpr double maxTreeSteps = 1500.0;
/// Charts are parted again this often at most.
constexpr int maxPartings = 3;
/// Where the mirror is worse than this, in sqrt(area / pi), cuts are tried from either side.
constexpr double unlikeSides = 0.01;
/// Of the price of pairs, below which other cuts are taken there.
constexpr double unpairedShare = 0.8;
/// Of the work, what cuts in pairs may take where the mirror is not exact.
constexpr double nearShare = 0.6;

/// Whether the surface may open into one piece along a tree of cuts. Of exact length the sides of a
/// tree's cuts hardly ever lie flat without an overlap.
bool growsTree(const ChartOptions& options)
{
  return options.pieces == 1 && options.darts && options.flattening.boundary == BoundaryMode::Free;
}

Indices numbersTo(Index count)
{
  Indices numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// The cut edges between charts of few triangles each.
std::vector<char> firstCuts(const TriangleMesh& mesh, double bound, bool holed)
{
  const std::vector<Indices> loops = holed ? mesh.boundaryLoops() : std::vector<Indices>{};
  const Indices chart = clusterTriangles(mesh, loops, findHoles(mesh, loops), bound);
  std::vector<char> cut(mesh.halfedgeCount(), 0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    const Index twin = mesh.twin(h);
    cut[h] = twin != none && chart[h / 3] != chart[twin / 3] ? 1 : 0;
  }
  return cut;
}

/// Each curve beside a triangle whose chart does not keep the bound.
std::vector<Indices> curvesBeside(const ImprintedSurface& surface, const std::vector<char>& keeping)
{
  std::vector<Indices> sets;
  for (std::size_t c = 0; c < surface.curves.size(); ++c)
  {
    bool bad = false;
    forEachEdge(surface.curves[c].vertices, [&](Index a, Index b) {
      for (Index h : { surface.mesh.find(a, b), surface.mesh.find(b, a) })
      {
        bad = bad || (h != none && !keeping[h / 3]);
      }
    });
    if (bad)
    {
      sets.push_back({ static_cast<Index>(c) });
    }
  }
  return sets;
}

/// The mesh cut along straight lines from end to end of its arcs, or as straight as they do not
/// meet and charts keep the bound.
CutMesh straightened(const TriangleMesh& mesh, const std::vector<CutArc>& arcs,
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
    budget.pay(SeamDrawing::steps * static_cast<double>(mesh.triangleCount()));
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
  if (best.mesh.triangleCount() > 0 && !execution.cancelled())
  {
    return best;
  }
  best.mesh = mesh;
  best.cut.assign(mesh.halfedgeCount(), 0);
  for (const CutArc& arc : arcs)
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
  const auto placeOf = [](const Point3& p) { return std::array{ p.x(), p.y(), p.z() }; };
  std::map<std::array<double, 3>, int> ends; // at each place
  for (const SuggestedCurve& cut : cuts)
  {
    ++ends[placeOf(cut.curve.points.front())];
    ++ends[placeOf(cut.curve.points.back())];
  }
  std::vector<char> paired;
  const auto pair = [&] {
    paired.assign(cuts.size(), 0);
    for (std::size_t k = 0; k < cuts.size(); ++k)
    {
      if (cuts[k].mirrorOf != none)
      {
        paired[k] = paired[cuts[k].mirrorOf] = 1;
      }
    }
  };
  const auto together = [&](std::size_t a, std::size_t b) {
    return cuts[b].mirrorOf == static_cast<Index>(a) || (!paired[a] && !paired[b]);
  };
  pair();
  for (std::size_t a = 0; a < cuts.size(); ++a)
  {
    for (std::size_t b = a + 1; b < cuts.size(); ++b)
    {
      if (cuts[a].curve.type != CurveType::Seam || cuts[b].curve.type != CurveType::Seam ||
        !together(a, b))
      {
        continue;
      }
      Points3& first = cuts[a].curve.points;
      Points3& second = cuts[b].curve.points;
      bool firstTurned = false;
      bool secondTurned = false;
      const auto meet = [&] {
        const Point3& end = firstTurned ? first.front() : first.back();
        const Point3& start = secondTurned ? second.back() : second.front();
        return end == start && ends[placeOf(end)] == 2;
      };
      for (int way = 0; way < 3 && !meet(); ++way)
      {
        (way == 1 ? secondTurned : firstTurned) ^= true;
      }
      if (!meet())
      {
        continue;
      }
      if (firstTurned)
      {
        std::reverse(first.begin(), first.end());
      }
      if (secondTurned)
      {
        std::reverse(second.begin(), second.end());
      }
      ends.erase(placeOf(first.back()));
      first.insert(first.end(), second.begin() + 1, second.end());
      cuts[a].length += cuts[b].length;
      cuts.erase(cuts.begin() + static_cast<std::ptrdiff_t>(b));
      for (SuggestedCurve& cut : cuts)
      {
        cut.mirrorOf -= cut.mirrorOf > static_cast<Index>(b) ? 1 : 0;
      }
      pair();
      --a; // it may be joined to others
      break;
    }
  }
  return cuts;
}

class ChartSearch
{
public:
  /// \param straight whether seams are drawn straight before charts are merged; otherwise charts that
  /// keep the bound on few triangles keep it on as many
  ChartSearch(const TriangleMesh& mesh, const std::optional<SymmetryPlane>& plane, bool straight,
    const ChartOptions& options, TrialBudget& budget, const Execution& execution)
    : Given(mesh)
    , Surface(mesh)
    , Straight(straight)
    , Options(options)
    , Bound(options.bound)
    , Budget(budget)
    , Run(execution)
    , Size(std::sqrt(mesh.area() / pi))
    , Trials(roughly(options.flattening), maxChartSteps)
  {
    if (plane)
    {
      this->Mirror = sectionOf(mesh, *plane);
    }
    this->Options.bound *= straight ? coarseShare : ruggedShare;
    this->Options.bound /= options.pieces > 0 ? finerBound : 1.0;
  }

  std::vector<SuggestedCurve> run()
  {
    if (growsTree(this->Options) && !this->Mirror)
    {
      std::vector<SuggestedCurve> cuts = this->onePiece();
      if (!cuts.empty())
      {
        return cuts;
      }
    }
    const TriangleMesh half = this->Mirror
      ? fewTriangles(halfOf(this->Surface, *this->Mirror), chartTriangles / 2)
      : fewTriangles(this->Surface, chartTriangles);
    if (half.triangleCount() == 0 || this->Budget.spent())
    {
      return {};
    }
    Charts first(half, firstCuts(half, firstShare * this->Options.bound, this->Options.holes),
      numbersTo(half.halfedgeCount()), this->Options, this->Size, this->Trials);
    TrialBudget budget(mergingShare * this->Budget.left(), this->Budget);
    first.divide(budget, this->Run.uninterrupted()); // a run that is cancelled ends with these
    CutMesh parted{ half, first.cut(), {} };
    this->preview(bothSides(withoutBridges(parted, this->Mirror), this->Mirror));
    if (this->Straight)
    {
      const auto straighten = [&](const TriangleMesh& mesh, const Charts& charts) {
        return this->Run.cancelled() ? CutMesh{ mesh, charts.cut(), {} }
                                     : straightened(mesh, charts.arcs(), this->Options, this->Size,
                                         this->Trials, budget, this->Run);
      };
      parted = straighten(half, first);
      ChartOptions rough = this->Options;
      rough.bound *= roughShare;
      rough.pieces = this->Mirror ? (rough.pieces + 1) / 2 : rough.pieces;
      Charts merged(parted.mesh, parted.cut, numbersTo(parted.mesh.halfedgeCount()), rough,
        this->Size, this->Trials);
      TrialBudget some(roughWork * budget.left(), budget);
      merged.divide(some, this->Run);
      merged.merge(true, some, this->Run);
      parted = straighten(parted.mesh, merged);
    }
    parted = withoutBridges(std::move(parted), this->Mirror);
    if (this->Mirror)
    {
      // A number of pieces is easier to reach where both sides are taken to be alike.
      this->Images = this->Options.pieces > 0
        ? this->Mirror->plane.mirrored(parted.mesh.points())
        : imagesOfHalf(parted.mesh, this->Surface, *this->Mirror);
    }
    const CutMesh whole = bothSides(parted, this->Mirror, this->Images);
    this->preview(whole);
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
    if (this->Options.darts)
    {
      TrialBudget sewing(sewingShare * this->Budget.left(), this->Budget);
      charts.shorten(sewing, this->Run);
    }
    this->preview({ whole.mesh, charts.cut(), whole.images });
    return this->settled(
      whole.mesh, parted.mesh.vertexCount(), charts.arcs(this->Mirror.has_value()), maxDrawnSteps);
  }

  /// How many pieces are folded, or lie over themselves, and the largest strain.
  double worst() const { return this->Settled.worst; }
  /// Whether it misses a bound, or has more pieces than are wanted.
  bool misses(double bound) const { return this->excess() > 0 || this->Settled.worst > bound; }
  /// Whether it misses it by far.
  bool fails(double bound) const { return this->misses(missedBy * bound); }
  /// The bound of charts, or what the number that is wanted keeps.
  double bound() const { return this->Bound; }
  /// Whether its cuts are better than another's: fewer pieces beyond the number that is wanted;
  /// then within the bound, or nearer to it; then fewer.
  bool betterThan(const ChartSearch& other, double bound) const
  {
    const auto merit = [bound](const ChartSearch& search) {
      const bool counted = search.Options.pieces > 0;
      return std::tuple(search.excess(),
        counted ? search.Settled.worst : std::max(search.Settled.worst, bound),
        search.Settled.cuts.size());
    };
    return merit(*this) < merit(other);
  }

private:
  Index excess() const
  {
    return this->Options.pieces > 0
      ? std::max<Index>(0, this->Settled.pieces - this->Options.pieces)
      : 0;
  }

  /// Hands on the seams as they run along edges.
  void preview(const CutMesh& parted)
  {
    if (!this->Run.preview)
    {
      return;
    }
    const Charts charts(
      parted.mesh, parted.cut, parted.images, this->Options, this->Size, this->Trials);
    std::vector<Points3> lines;
    for (const CutArc& arc : charts.arcs())
    {
      lines.emplace_back();
      for (Index v : arc.vertices)
      {
        lines.back().push_back(parted.mesh.point(v));
      }
    }
    this->Run.preview(lines);
  }

  /// The surface as one piece, opened along a tree until it keeps the bound, or as near to it as it
  /// comes; none where the surface itself does not lie so.
  std::vector<SuggestedCurve> onePiece()
  {
    const TriangleMesh mesh = fewTriangles(this->Surface, chartTriangles);
    if (!SeamTree::opens(mesh))
    {
      return {};
    }
    ChartOptions options = this->Options;
    options.bound = ruggedShare * this->Bound;
    options.hopelessShare = std::numeric_limits<double>::infinity();
    ChartTrials trials(roughly(options.flattening), maxTreeSteps, true);
    SeamTree tree(mesh);
    TrialBudget growing(growingShare * this->Budget.left(), this->Budget);
    constexpr double any = std::numeric_limits<double>::infinity();
    const auto laid = [&](const std::vector<char>& opened, double enough, TrialBudget& budget) {
      const OpenedPart disk = openedPart(mesh, numbersTo(mesh.triangleCount()), opened);
      return trials.run({ { disk.mesh } }, enough, budget, this->Run).front();
    };
    std::vector<char> cut;
    double strain = any;
    double step = nextForecast;
    for (double share = firstForecast; strain > options.bound && share > lastForecast &&
         tree.grow(share * options.bound, growing, this->Run);
         share *= share * step > lastForecast ? step : nextForecast)
    {
      const ChartTrials::Result flat = laid(tree.cut(), options.bound, growing);
      const double lastStep = std::exchange(step, nextForecast);
      if (flat.sound && flat.strain < strain)
      {
        const double left = std::max(flat.strain, options.bound);
        const double power = strain < any
          ? std::max(leastPower, std::log(lastStep) / std::min(-leastFall, std::log(left / strain)))
          : leastPower;
        cut = tree.cut();
        strain = flat.strain;
        step = std::clamp(std::pow(options.bound / left, power), leastStep, nextForecast);
      }
    }
    if (!cut.empty() && strain > options.bound)
    {
      strain = laid(cut, any, this->Budget).strain; // as the piece will be
    }
    if (!std::isfinite(strain))
    {
      return {};
    }
    options.bound = std::max(options.bound, strain);
    const double given = this->Bound;
    this->Bound = std::max(given, strain / ruggedShare);
    this->preview({ mesh, cut, numbersTo(mesh.halfedgeCount()) });
    Charts chart(mesh, cut, numbersTo(mesh.halfedgeCount()), options, this->Size, trials);
    TrialBudget sewing(mergingShare * this->Budget.left(), this->Budget);
    chart.divide(sewing, this->Run);
    chart.merge(false, sewing, this->Run);
    chart.shorten(sewing, this->Run);
    std::vector<SuggestedCurve> cuts =
      this->settled(mesh, mesh.vertexCount(), chart.arcs(false), maxTreeSteps);
    if (this->fails(this->Bound))
    {
      this->Bound = given;
      this->Settled = {};
      return {};
    }
    return cuts;
  }

  /// The arcs as seams of the surface itself.
  std::vector<SuggestedCurve> settled(
    const TriangleMesh& mesh, Index half, const std::vector<CutArc>& arcs, double most)
  {
    this->Settled =
      settleSeams(this->Given, this->Surface, this->Mirror, this->seams(mesh, half, arcs),
        this->Bound, most, this->Options.flattening, this->Budget, this->Run);
    std::vector<SuggestedCurve> cuts = joined(this->Settled.cuts);
    const CutTrials trials(this->Given, {}, {}, this->Options.flattening);
    return trials.paths(linesOf(cuts)).empty() ? this->Settled.cuts : cuts;
  }

  /// \param half how many vertices are on one side of the plane
  std::vector<ChartSeam> seams(
    const TriangleMesh& mesh, Index half, const std::vector<CutArc>& arcs) const
  {
    std::vector<ChartSeam> seams;
    for (bool darts : { false, true })
    {
      for (const CutArc& arc : arcs)
      {
        ChartSeam seam;
        seam.dart = arc.dart;
        bool inside = false;
        for (Index v : arc.vertices)
        {
          if (v < half)
          {
            seam.chain.push_back(mesh.point(v));
            if (this->Mirror)
            {
              seam.imageChain.push_back(this->Images[v]);
            }
            inside = inside || !(this->Mirror && this->Mirror->has(mesh.point(v)));
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
          std::reverse(seam.imageChain.begin(), seam.imageChain.end());
        }
        seam.paired = this->Mirror && !seam.crosses && inside;
        const bool closed = arc.vertices.front() == arc.vertices.back();
        seam.least = seam.level = !inside ? SeamDrawing::levels - 1 : closed ? 1 : 0;
        seams.push_back(std::move(seam));
      }
    }
    return seams;
  }

  const TriangleMesh& Given;
  TriangleMesh Surface; ///< with the section of the plane
  std::optional<MirrorSection> Mirror;
  bool Straight;
  ChartOptions Options; ///< on few triangles
  double Bound;
  TrialBudget& Budget;
  const Execution& Run;
  double Size;        ///< sqrt(area / pi)
  Points3 Images;     ///< of the half of few triangles, with a mirror
  ChartTrials Trials; ///< on few triangles
  SettledSeams Settled;
};

/// See ChartSearch::worst(); infinity where the cuts cannot be laid into the surface.
double worstOf(const TriangleMesh& mesh, const std::vector<SuggestedCurve>& cuts,
  ChartTrials& trials, TrialBudget& budget, const Execution& execution)
{
  if (CutTrials(mesh, {}, {}, {}).paths(linesOf(cuts)).empty())
  {
    return std::numeric_limits<double>::infinity();
  }
  const ImprintedSurface surface = imprintCurves(mesh, linesOf(cuts), {});
  return DrawnPieces(cutSurface(surface.mesh, surface.curves), trials, budget, execution).worst();
}

/// Adds sets of cuts in different pieces, which may come too near to each other: as many at once as
/// can be laid. False where none can.
bool layCuts(const TriangleMesh& mesh, const std::vector<std::vector<SuggestedCurve>>& sets,
  std::size_t begin, std::size_t end, std::vector<SuggestedCurve>& cuts)
{
  std::vector<SuggestedCurve> more = cuts;
  for (std::size_t s = begin; s < end; ++s)
  {
    const auto first = static_cast<Index>(more.size());
    for (SuggestedCurve cut : sets[s])
    {
      cut.mirrorOf += cut.mirrorOf == none ? 0 : first;
      more.push_back(std::move(cut));
    }
  }
  openDividingDarts(mesh, {}, {}, more);
  more = laidTogether(mesh, std::move(more));
  if (!more.empty() || end - begin < 2)
  {
    cuts = more.empty() ? cuts : more;
    return !more.empty();
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const bool first = layCuts(mesh, sets, begin, middle, cuts);
  return layCuts(mesh, sets, middle, end, cuts) || first;
}

/// Adds cuts in the pieces that do not keep a bound yet. False where there are none.
bool addCuts(const TriangleMesh& mesh, const std::optional<SurfaceMirror>& mirror, bool straight,
  const ChartOptions& options, double bound, std::vector<SuggestedCurve>& cuts, ChartTrials& trials,
  TrialBudget& budget, const Execution& execution)
{
  const ImprintedSurface surface = imprintCurves(mesh, linesOf(cuts), {});
  if (!surface.status.ok())
  {
    return false;
  }
  previewCuts(cuts, execution);
  const DrawnPieces drawn(cutSurface(surface.mesh, surface.curves), trials, budget, execution);
  const std::vector<Piece>& pieces = drawn.pieces;
  const Indices images =
    pieceImages(pieceSurfaces(surface, drawn.cut), mirror, std::sqrt(mesh.area() / pi), true);
  Execution unseen = execution;
  unseen.preview = nullptr;                      // of single pieces
  std::vector<std::vector<SuggestedCurve>> sets; // by piece that is parted
  std::size_t count = cuts.size();
  std::vector<char> done(pieces.size(), 0);
  for (std::size_t p = 0; p < pieces.size() && !budget.spent(); ++p)
  {
    if (done[p] || drawn.results[p].keeps(bound) || static_cast<double>(count) > options.maxCuts)
    {
      continue;
    }
    ChartOptions here = options;
    here.holes = straight; // the next time
    std::vector<SuggestedCurve> found;
    double worst = drawn.fault(p);
    const auto tryCharts = [&](const std::optional<SymmetryPlane>& plane) {
      ChartSearch search(pieces[p].mesh, plane, straight, here, budget, unseen);
      std::vector<SuggestedCurve> next = search.run();
      const bool any = !next.empty();
      if (search.worst() < worst)
      {
        worst = search.worst();
        found = std::move(next);
      }
      return any;
    };
    const bool alike = images[p] == static_cast<Index>(p);
    if (alike)
    {
      tryCharts(measuredPlane(pieces[p].mesh, *mirror->plane()));
    }
    // What is flat on few triangles, and not on many, is parted into at least this number of
    // charts.
    for (Index least : { 0, 2, 3, 4, 6 })
    {
      if ((!found.empty() && worst <= bound) || budget.spent())
      {
        break;
      }
      here.pieces = least;
      if (!tryCharts(std::nullopt) && least > 0)
      {
        break; // nor do more charts
      }
    }
    if (!found.empty() && images[p] > static_cast<Index>(p))
    {
      done[images[p]] = addImages(
        found, 0, *mirror, pieces[p].mesh, pieces[images[p]].mesh, options, budget, execution);
    }
    if (!found.empty())
    {
      count += found.size();
      sets.push_back(std::move(found));
    }
  }
  return !sets.empty() && layCuts(mesh, sets, 0, sets.size(), cuts);
}
}

bool addImages(std::vector<SuggestedCurve>& cuts, Index first, const SurfaceMirror& mirror,
  const TriangleMesh& piece, const TriangleMesh& image, const ChartOptions& options,
  TrialBudget& budget, const Execution& execution)
{
  const std::size_t count = cuts.size();
  addImages(cuts, first, mirror);
  if (mirror.error <= SurfaceMirror::exact)
  {
    return true;
  }
  const SeamDrawing drawing(piece);
  const SeamDrawing other(image);
  for (std::size_t k = count; k < cuts.size(); ++k)
  {
    const Points3& points = cuts[cuts[k].mirrorOf].curve.points;
    cuts[k].curve.points = other.draw(
      drawing.imageOn(other, drawing.place(points), *mirror.plane()), SeamDrawing::levels - 1);
    cuts[k].length = polylineLength(cuts[k].curve.points);
  }
  const std::vector<SuggestedCurve> added(
    cuts.begin() + static_cast<std::ptrdiff_t>(count), cuts.end());
  ChartTrials trials(options.flattening, maxDrawnSteps);
  if (worstOf(image, added, trials, budget, execution) <= missedBy * options.bound)
  {
    return true;
  }
  cuts.resize(count);
  return false;
}

std::vector<SuggestedCurve> chartCuts(const TriangleMesh& mesh,
  const std::optional<SymmetryPlane>& plane, const ChartOptions& options, TrialBudget& budget,
  const Execution& execution)
{
  const std::optional<SurfaceMirror> mirror =
    plane ? std::optional<SurfaceMirror>(*plane) : std::nullopt;
  const double bound = missedBy * options.bound; // darts do for what is nearer
  if (const std::optional<TriangleMesh> few = coarseVersion(mesh))
  {
    std::optional<SurfaceMirror> moved = mirror;
    std::vector<SuggestedCurve> cuts =
      movedCuts(mesh, moved, chartCuts(*few, plane, options, budget, execution));
    return partedCharts(mesh, mirror, options, bound, std::move(cuts), budget, execution);
  }
  // What is left has to do for cuts without the mirror, where its two sides differ too much.
  const bool near = plane && plane->error > SurfaceMirror::exact && !options.mirrorKept;
  TrialBudget trying(near ? nearShare * budget.left() : budget.left(), budget);
  ChartSearch first(mesh, plane, true, options, trying, execution);
  std::vector<SuggestedCurve> cuts = first.run();
  if (execution.cancelled())
  {
    // A plane need not part the surface.
    return cuts.empty() && plane ? chartCuts(mesh, std::nullopt, options, budget, execution) : cuts;
  }
  const ChartSearch* best = &first;
  std::optional<ChartSearch> second;
  if (plane && plane->error > unlikeSides)
  {
    second.emplace(mesh, SymmetryPlane{ -plane->normal, -plane->offset, plane->error }, true,
      options, trying, execution);
    std::vector<SuggestedCurve> others = second->run();
    if (second->betterThan(first, options.bound))
    {
      cuts = std::move(others);
      best = &*second;
    }
  }
  const bool opens = growsTree(options) && !options.mirrorKept;
  const bool missed = opens ? best->misses(options.bound) : best->fails(best->bound());
  bool failed = plane && (cuts.empty() || ((near || options.pieces == 1) && missed));
  if (failed && near && !cuts.empty() && options.pieces == 0)
  {
    cuts = partedCharts(mesh, mirror, options, bound, std::move(cuts), trying, execution);
    ChartTrials trials(options.flattening, maxDrawnSteps);
    failed = worstOf(mesh, cuts, trials, trying, execution) > bound;
  }
  if (failed && (opens || options.pieces > 0) && !cuts.empty())
  {
    ChartSearch whole(mesh, std::nullopt, true, options, budget, execution);
    std::vector<SuggestedCurve> others = whole.run();
    return !others.empty() && whole.betterThan(*best, options.bound) ? others : cuts;
  }
  if (failed || (near && (second || missed)))
  {
    std::vector<SuggestedCurve> others = chartCuts(mesh, std::nullopt, options, budget, execution);
    const auto price = [&](const std::vector<SuggestedCurve>& set) {
      return priceOf(set, std::sqrt(mesh.area() / pi));
    };
    if (!others.empty() && (failed || price(others) < unpairedShare * price(cuts)))
    {
      return others;
    }
  }
  // What missed the bound and does not fail any more has been parted.
  return near && missed && !failed && options.pieces == 0
    ? cuts
    : partedCharts(mesh, mirror, options, bound, std::move(cuts), budget, execution);
}

std::vector<SuggestedCurve> partedCharts(const TriangleMesh& mesh,
  const std::optional<SurfaceMirror>& mirror, const ChartOptions& options, double bound,
  std::vector<SuggestedCurve> cuts, TrialBudget& budget, const Execution& execution)
{
  ChartTrials trials(options.flattening, maxDrawnSteps);
  const int partings = options.pieces > 0 ? 0 : maxPartings;
  for (int k = 0; k < partings && !cuts.empty() && !budget.spent() && !execution.cancelled(); ++k)
  {
    if (!addCuts(mesh, mirror, k == 0, options, bound, cuts, trials, budget, execution) && k > 0)
    {
      break;
    }
  }
  return cuts;
}
}
