// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceFlattening.h"

#include "Angles/AngleSolver.h"
#include "Base/Execution.h"
#include "Base/Types.h"
#include "Cut/CutClosure.h"
#include "Embedding/ConvexEmbedding.h"
#include "Embedding/LeastSquaresConformalMap.h"
#include "Flattening/ClothPlacement.h"
#include "Flattening/PieceReports.h"
#include "Flattening/PieceSolution.h"
#include "Flattening/PieceWarping.h"
#include "Flattening/PieceWires.h"
#include "Quality/BoundaryOverlap.h"
#include "Quality/FlatteningQuality.h"
#include "Wires/KeyCurveLocks.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Larger tubes are only mapped: warping one takes minutes, and nothing can be cut by the result.
constexpr Index maximumTubeTriangles = 20000;

/// The least squares conformal map of the piece.
void mapPiece(const PieceContext& context, PieceSolution& solution)
{
  LeastSquaresConformalOptions conformal = context.options.conformal;
  for (Index& pin : conformal.pins)
  {
    // The first copy of the pinned vertex in this piece.
    const Indices& vertices = context.piece.vertices;
    const auto copy = std::find_if(vertices.begin(), vertices.end(),
      [&](Index v) { return pin != none && context.cut.originalVertex[v] == pin; });
    pin = copy == vertices.end() ? none : static_cast<Index>(copy - vertices.begin());
  }
  if (conformal.pins[0] == none || conformal.pins[1] == none)
  {
    conformal.pins = { none, none };
  }
  LeastSquaresConformalMap map =
    leastSquaresConformalMap(context.piece.mesh, conformal, context.execution);
  solution.positions = std::move(map.positions);
  solution.placement = std::move(map.status);
}

PieceSolution flattenConformally(const PieceContext& context)
{
  Stopwatch watch;
  PieceSolution piece;
  // The map holds no wire, but what it does to them is measured.
  piece.problem = makeAngleProblem(context.network, freeNodes(context.network));
  mapPiece(context, piece);
  layOnCloth(context, piece);
  piece.status = piece.placement;
  piece.secondsInterior = watch.seconds();
  return piece;
}

/// A tube without its lengths. Without a value where it cannot be mapped or the run was cancelled.
std::optional<PieceSolution> mapTube(const PieceContext& context, const PieceSolution& wires)
{
  PieceSolution piece = wires;
  piece.positions = embedConvexly(context.piece.mesh, context.execution);
  if (piece.positions.empty())
  {
    return std::nullopt;
  }
  piece.status = { StatusCode::NotConverged,
    "the piece is a tube, which no plane can hold; with " +
      std::to_string(context.piece.mesh.triangleCount()) +
      " triangles it is only mapped, without its lengths",
    {}, {} };
  layOnCloth(context, piece);
  return piece;
}

/// A piece for which the plane has no room, from a convex embedding at once: placed by its wires'
/// angles it would fold, and untangling it would take long and help little. Without a value where
/// that does not keep what was asked for.
std::optional<PieceSolution> flattenDeepPiece(
  const PieceContext& context, const PieceSolution& wires)
{
  if (!context.exceedsPlanarArea() || context.options.scheme != Scheme::Isometric ||
    wires.status.refused())
  {
    return std::nullopt;
  }
  context.execution.report(0.1, "Flattening a piece that no plane can hold");
  if (context.area->tube() && context.piece.mesh.triangleCount() > maximumTubeTriangles)
  {
    return mapTube(context, wires);
  }
  std::optional<PieceSolution> piece =
    warpFromConvexStart(context, wires, context.options.isometric);
  const bool good = piece && (piece->placement.ok() || !wires.locks()) &&
    countFlipped(context.piece.mesh, piece->positions) == 0;
  if (!good)
  {
    return std::nullopt;
  }
  layOnCloth(context, *piece);
  if (piece->status.code == StatusCode::NotConverged)
  {
    piece->status = {}; // of angles that were not used
  }
  noteStatus(piece->placement, piece->status);
  return piece;
}

/// With a free boundary the wires have no angles to start from. Without a value where the piece
/// has no map without a fold.
std::optional<PieceSolution> flattenFreely(const PieceContext& context, const CurveRules& rules)
{
  PieceSolution wires;
  wires.rules = rules;
  if (context.options.releaseKeys)
  {
    wires.rules.released = keyCurves(context.network, context.piece, context.cut, context.curves);
  }
  wires.problem =
    makeWireProblem(context.network, context.piece, context.cut, context.curves, wires.rules);
  std::optional<PieceSolution> piece =
    warpFromConvexStart(context, wires, context.options.isometric);
  if (piece)
  {
    piece->fromConvexStart = false;
    layOnCloth(context, *piece);
    noteStatus(piece->placement, piece->status);
  }
  return piece;
}

/// Angles without a solution were only a start; where there is a remedy it is named.
void forgetAngles(const PieceContext& context, PieceSolution& piece)
{
  const bool good = piece.status.remedies.empty() && piece.placement.ok() && piece.isometric &&
    piece.isometric->status.ok() && countFlipped(context.piece.mesh, piece.positions) == 0;
  if (good && piece.status.code == StatusCode::NotConverged)
  {
    piece.status = {};
  }
}

/// The same for a piece whose wires are solved and placed.
void finishScheme(const PieceContext& context, PieceSolution& piece)
{
  const bool warps = context.options.scheme == Scheme::Isometric && !piece.status.refused() &&
    !piece.placement.refused();
  if (warps)
  {
    warpPiece(context, piece);
  }
  layOnCloth(context, piece);
  if (warps)
  {
    forgetAngles(context, piece);
  }
  noteStatus(piece.placement, piece.status);
}

/// Flattens a piece, as its cuts are, by the scheme of the options. Keys that clash are released.
PieceSolution flattenByScheme(const PieceContext& context, const CurveRules& rules)
{
  if (context.network.status.refused())
  {
    PieceSolution piece;
    piece.status = context.network.status;
    return piece;
  }
  if (context.options.scheme == Scheme::LeastSquaresConformal)
  {
    return flattenConformally(context);
  }
  Stopwatch watch;
  if (std::optional<PieceSolution> continued = warpFromGivenStart(context, rules))
  {
    continued->secondsInterior = watch.seconds();
    return std::move(*continued);
  }
  if (rules.freeBoundary)
  {
    if (std::optional<PieceSolution> freely = flattenFreely(context, rules))
    {
      freely->secondsInterior = watch.seconds();
      return std::move(*freely);
    }
  }
  watch.restart();
  PieceSolution piece = solveWithKeys(context, rules);
  double seconds = watch.restart();
  if (std::optional<PieceSolution> deep = flattenDeepPiece(context, piece))
  {
    deep->secondsWires = seconds;
    deep->secondsInterior = watch.seconds();
    return std::move(*deep);
  }
  placeWires(context, piece);
  const bool solved = piece.status.ok();
  finishScheme(context, piece);
  double interior = watch.restart();
  std::optional<PieceSolution> released;
  if (solved)
  {
    released = releaseFoldingKeys(context, piece);
    seconds += watch.restart();
  }
  if (released)
  {
    piece = std::move(*released);
    finishScheme(context, piece);
    interior += watch.seconds();
  }
  piece.secondsWires = seconds;
  piece.secondsInterior = interior;
  return piece;
}

/// Triangles. A larger piece that has come to no good end by one way takes too long by six.
constexpr Index largeTrial = 3000;
/// A piece whose homogeneity of distortion falls below this lies poorly: areas are changed by more
/// than 2.5 against each other. Pieces as they are cut in practice stay above 0.48; below are those
/// on which the curves have no good exact solution together.
constexpr double poorHomogeneity = 0.4;

/// Legs of darts that fold and take more than this many times the energy of free ones are reported:
/// on 24 real pieces of garments most take 1.0 to 1.5 times, three 2.3 to 4.4.
constexpr double dearFolds = 2.0;

PieceContext contextOf(
  WiredPiece& wired, const PieceSettings& settings, const Execution& execution, bool keep)
{
  if (!wired.network)
  {
    wired.network = buildWireNetwork(wired.piece, wired.disk);
  }
  // Without the boundary's length nothing wants room, and a start says that there is some.
  const bool wanted = settings.options.start.empty() &&
    settings.options.scheme != Scheme::LeastSquaresConformal &&
    settings.options.boundary == BoundaryMode::Exact;
  if (wanted && !(wired.area && wired.area->known))
  {
    wired.area = forecastArea(wired.piece.mesh, execution);
  }
  return { wired.piece, *wired.network, settings.cut, settings.curves, settings.options, execution,
    keep ? &wired.interiors : nullptr, wanted ? &*wired.area : nullptr };
}

/// Whether a solution is as good as the one before it but for the lengths that it keeps.
bool isAsGood(
  const PieceContext& context, const PieceSolution& next, Index flippedBefore, const Status& before)
{
  return (next.status.ok() || next.status.code == before.code) &&
    countFlipped(context.piece.mesh, next.positions) <= flippedBefore;
}

/// By curve the turning angles of darts' legs, as in CurveRules::legTurns, from the piece with free
/// legs; darts that branch are added to the free ones.
std::vector<std::vector<double>> turnsOfLegs(
  const PieceContext& context, const std::vector<DartSideVertex>& vertices, PieceSolution& piece)
{
  const std::size_t curves = context.curves.size();
  std::vector<Points2> sums(curves); // of the left and the right side
  std::vector<Index> found(curves, 0);
  std::vector<char> aroundHole(curves, 0);
  for (const DartSideVertex& vertex : vertices)
  {
    const auto c = static_cast<std::size_t>(vertex.curve);
    const Point2& at = piece.positions[context.network.hostVertices[vertex.host]];
    const Point2 in = at - piece.positions[vertex.before];
    const Point2 out = piece.positions[vertex.after] - at;
    sums[c].resize(context.curves[c].vertices.size(), Point2::Zero());
    sums[c][vertex.place][vertex.onLeft ? 0 : 1] = std::atan2(cross(in, out), in.dot(out));
    ++found[c];
    aroundHole[c] = aroundHole[c] || context.network.interior[vertex.host];
  }
  std::vector<std::vector<double>> turns(curves);
  for (std::size_t c = 0; c < curves; ++c)
  {
    const auto inner = static_cast<Index>(context.curves[c].vertices.size()) - 2;
    if (found[c] != 0 && found[c] != 2 * inner)
    {
      piece.freeDarts.push_back(static_cast<Index>(c));
      continue;
    }
    const bool straight = context.options.dartLegs == DartLegs::Straight && !aroundHole[c];
    for (const Point2& both : sums[c])
    {
      turns[c].push_back(straight ? 0.0 : both.sum() / 2.0);
    }
  }
  return turns;
}

/// With these darts folding; whether that is as good as the piece, which it then replaces.
bool foldDarts(const PieceContext& context, const Indices& darts,
  const std::vector<std::vector<double>>& turns, CurveRules rules, PieceSolution& piece)
{
  rules.legTurns.resize(context.curves.size());
  for (const Index dart : darts)
  {
    rules.legTurns[dart] = turns[dart];
  }
  PieceSolution folded = flattenByScheme(context, rules);
  const bool good = !folded.status.refused() && !folded.positions.empty() &&
    folded.rules.released.size() <= piece.rules.released.size() &&
    isAsGood(context, folded, countFlipped(context.piece.mesh, piece.positions), piece.status) &&
    countBoundaryOverlaps(context.piece.mesh, folded.positions, 0).count <=
      countBoundaryOverlaps(context.piece.mesh, piece.positions, 0).count;
  folded.secondsWires += piece.secondsWires;
  folded.secondsInterior += piece.secondsInterior;
  folded.freeDarts = piece.freeDarts;
  if (good)
  {
    piece = std::move(folded);
  }
  return good;
}

/// One dart after the other folds, where all together do not.
void foldEach(const PieceContext& context, const Indices& darts,
  const std::vector<std::vector<double>>& turns, const CurveRules& rules, PieceSolution& piece)
{
  Indices folded;
  for (const Index dart : darts)
  {
    folded.push_back(dart);
    const bool alone = darts.size() == 1; // tried already
    if (alone || context.execution.cancelled() || !foldDarts(context, folded, turns, rules, piece))
    {
      folded.pop_back();
      piece.freeDarts.push_back(dart);
    }
  }
  std::sort(piece.freeDarts.begin(), piece.freeDarts.end());
}

/// By the scheme of the options, first with free legs of darts, then with those that the options
/// want. A dart whose legs cannot be so (it branches, keys would have to be released, triangles
/// would fold over, the piece would overlap itself, there is no solution) keeps free ones.
PieceSolution flattenWithDarts(const PieceContext& context, const CurveRules& rules)
{
  PieceSolution piece = flattenByScheme(context, rules);
  const bool free = !context.options.foldsDarts() ||
    context.options.scheme == Scheme::LeastSquaresConformal || piece.status.refused() ||
    piece.positions.empty();
  if (free)
  {
    return piece;
  }
  const std::vector<std::vector<double>> turns = turnsOfLegs(
    context, findDartSides(context.network, context.piece, context.cut, context.curves), piece);
  Indices folding;
  for (std::size_t c = 0; c < turns.size(); ++c)
  {
    if (!turns[c].empty())
    {
      folding.push_back(static_cast<Index>(c));
    }
  }
  if (folding.empty())
  {
    return piece;
  }
  const auto measured = [&context](const PieceSolution& one) {
    return measureFlattening(context.piece.mesh, one.positions, {}, context.execution).summary;
  };
  const QualitySummary before = measured(piece);
  if (!foldDarts(context, folding, turns, rules, piece))
  {
    foldEach(context, folding, turns, rules, piece);
  }
  const QualitySummary after = measured(piece);
  if (after.rigidEnergy > dearFolds * before.rigidEnergy && after.strainP95 > before.strainP95)
  {
    piece.strainOfFreeLegs = before.strainP95;
    piece.strainOfLegs = after.strainP95;
  }
  return piece;
}

double workOf(const PieceContext& context, const PieceSolution& piece)
{
  return static_cast<double>(piece.factorizations) *
    static_cast<double>(context.piece.mesh.triangleCount());
}

/// The piece's flattening without another trial of releases. \param work what it took is added
ReleaseTrial tryRelease(
  const PieceContext& context, const CurveRules& rules, Index curve, double& work)
{
  ReleaseTrial trial;
  trial.curve = curve;
  PieceSolution piece = solveWires(context, rules);
  if (piece.status.refused())
  {
    return trial;
  }
  const bool solved = piece.status.ok();
  placeWires(context, piece);
  finishScheme(context, piece);
  work += workOf(context, piece);
  // Angles without a solution may be start enough for a scheme that ends well.
  if (piece.status.refused() || !(solved || piece.status.ok()))
  {
    return trial;
  }
  const QualitySummary quality =
    measureFlattening(context.piece.mesh, piece.positions, {}, context.execution).summary;
  trial.solved = true;
  trial.objective = measureWires(piece.problem, piece.positions).objective;
  trial.areaError = quality.areaError;
  trial.homogeneity = quality.globalHomogeneity;
  return trial;
}

/// A key curve without its shape, any other one as no wire any more.
ReleaseTrial tryWithout(const PieceContext& context, CurveRules rules, Index curve, double& work)
{
  if (context.curves[curve].type == CurveType::Key && !rules.releases(curve))
  {
    rules.released.insert(
      std::upper_bound(rules.released.begin(), rules.released.end(), curve), curve);
    return tryRelease(context, rules, curve, work);
  }
  Piece bare = context.piece;
  std::replace(bare.curveOfHalfedge.begin(), bare.curveOfHalfedge.end(), curve, none);
  const WireNetwork fewer = buildWireNetwork(bare, true);
  return tryRelease(
    { bare, fewer, context.cut, context.curves, context.options, context.execution }, rules, curve,
    work);
}

/// Whether trials may find something better: the piece lies poorly, or wires' angles change by
/// much.
bool wantsTrials(const PieceContext& context, const PieceSolution& piece)
{
  const TriangleMesh& mesh = context.piece.mesh;
  // What is cut in the end needs no advice on releases.
  const bool slow = mesh.triangleCount() > largeTrial &&
    (!piece.status.ok() || countFlipped(mesh, piece.positions) > 0);
  if (!context.options.tryReleases || context.exceedsPlanarArea() || slow)
  {
    return false;
  }
  // The Laplacian interior distorts by itself, whatever the wires.
  const bool poor = context.options.interior.method == InteriorMethod::AsRigidAsPossible &&
    !(measureDistortion(mesh, piece.positions, context.execution).globalHomogeneity >=
      poorHomogeneity);
  return poor || !piece.angles.status.ok() || piece.status.code == StatusCode::IncompatibleKeys ||
    largestAngleChange(piece.problem, piece.angles.theta) > poorAngleChange;
}

/// Which curves to release for a better piece. Where that may help, the most promising curves are
/// tried: the piece is flattened anew without each, by the same scheme with the same options.
ReleaseAdvice adviseByTrials(const PieceContext& context, const PieceSolution& piece)
{
  const Scheme scheme = context.options.scheme;
  if (scheme == Scheme::Progressive || scheme == Scheme::LeastSquaresConformal ||
    piece.status.refused() || piece.fromGivenStart || piece.rules.freeBoundary)
  {
    return {};
  }
  ReleaseAdvice advice = adviseRelease(context.network, context.curves, piece.angles);
  if (!wantsTrials(context, piece))
  {
    return advice;
  }
  const Execution execution = context.execution.part(1.0, 1.0);
  const PieceContext inner{ context.piece, context.network, context.cut, context.curves,
    context.options, execution };
  std::vector<ReleaseTrial> trials;
  double work = 0.0;
  // Another flattening of the piece is expected to take as much as this one.
  const double expected = workOf(context, piece);
  for (Index curve : releaseCandidates(advice, context.network, context.curves,
         keyCurves(context.network, context.piece, context.cut, context.curves),
         piece.rules.released, piece.angles))
  {
    if (work + expected > context.options.trialWork)
    {
      break;
    }
    trials.push_back(tryWithout(inner, piece.rules, curve, work));
  }
  rankReleases(trials,
    scheme == Scheme::Isometric ? ReleaseMeasure::AreaError : ReleaseMeasure::Objective, advice);
  return advice;
}

/// Fills in the report, and lets go of what only the steps read.
void finish(const PieceContext& context, PieceSolution& piece)
{
  reportPiece(context, piece);
  Stopwatch watch;
  piece.report.advice = adviseByTrials(context, piece);
  piece.secondsWires += watch.seconds();
  piece.problem = {};
  piece.angles = {};
  piece.isometric.reset();
}

/// A piece with sides of its cuts joined, flattened.
struct ClosedPiece
{
  WiredPiece wired;
  Indices place; ///< per vertex of the piece before, its vertex now
  PieceSolution solution;

  /// Per vertex of the piece before.
  Points2 positions() const
  {
    Points2 all;
    for (Index v : this->place)
    {
      all.push_back(this->solution.positions[v]);
    }
    return all;
  }

  /// With edges between vertices of the piece before.
  WireNetwork network() const
  {
    Indices vertexOf(this->wired.piece.vertices.size());
    for (std::size_t v = 0; v < this->place.size(); ++v)
    {
      vertexOf[this->place[v]] = static_cast<Index>(v);
    }
    WireNetwork network = *this->wired.network;
    for (WireEdge& edge : network.edges)
    {
      edge.from = vertexOf[edge.from];
      edge.to = vertexOf[edge.to];
    }
    return network;
  }
};

/// Flattens the piece with more and more of its cuts closed, until none cross. Without a value
/// where there is nothing to close, or closing does not help.
std::optional<PieceSolution> flattenWithClosedCuts(const PieceContext& context,
  const PieceSettings& settings, const CurveRules& rules, PieceSolution& open)
{
  const Index flipped = countFlipped(context.piece.mesh, open.positions);
  const Execution execution = context.execution.part(1.0, 1.0);
  std::unique_ptr<ClosedPiece> closed; // solutions refer to it
  const auto flatten = [&](const Indices& joined) -> std::optional<Points2> {
    if (closed && closed->solution.status.code == StatusCode::Cancelled)
    {
      return std::nullopt;
    }
    closed = std::make_unique<ClosedPiece>();
    JoinedPiece joinedPiece = joinVertices(context.piece, joined);
    closed->place = std::move(joinedPiece.place);
    closed->wired.piece = std::move(joinedPiece.piece);
    const PieceContext inner = contextOf(closed->wired, settings, execution, false);
    closed->solution = flattenWithDarts(inner, rules);
    open.secondsWires += closed->solution.secondsWires;
    open.secondsInterior += closed->solution.secondsInterior;
    return isAsGood(inner, closed->solution, flipped, open.status)
      ? std::optional<Points2>(closed->positions())
      : std::nullopt;
  };
  Indices edges = closeCuts(context.piece, context.cut, open.positions, flatten);
  const bool cancelled = closed && closed->solution.status.code == StatusCode::Cancelled;
  if (edges.empty() && !cancelled)
  {
    return std::nullopt;
  }
  PieceSolution solution = std::move(closed->solution);
  solution.secondsWires = open.secondsWires;
  solution.secondsInterior = open.secondsInterior;
  finish(contextOf(closed->wired, settings, execution, false), solution);
  if (!cancelled)
  {
    // On the piece and the surface before.
    closed->solution.positions = std::move(solution.positions);
    solution.positions = closed->positions();
    solution.joinedNetwork = closed->network();
    solution.report.vertices = context.piece.mesh.vertexCount();
    for (Index& h : edges)
    {
      h = 3 * context.piece.triangles[h / 3] + h % 3;
    }
    std::sort(edges.begin(), edges.end());
    solution.report.closedEdges = std::move(edges);
  }
  return solution;
}
}

PieceSolution flattenPiece(WiredPiece& wired, const PieceSettings& settings,
  const CurveRules& rules, const Execution& execution)
{
  const PieceContext context = contextOf(wired, settings, execution, settings.keep);
  PieceSolution solution = flattenWithDarts(context, rules);
  if (settings.options.closeCuts && !solution.status.refused())
  {
    if (std::optional<PieceSolution> closed =
          flattenWithClosedCuts(context, settings, rules, solution))
    {
      return std::move(*closed);
    }
  }
  finish(context, solution);
  return solution;
}
}
