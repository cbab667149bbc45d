// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/SurfaceFlattening.h"

#include "Base/Execution.h"
#include "Base/Memory.h"
#include "Flattening/FlatteningCache.h"
#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"
#include "Flattening/PieceArrangement.h"
#include "Flattening/PieceFlattening.h"
#include "Flattening/PieceReports.h"
#include "Flattening/WireReport.h"
#include "Quality/FlatteningQuality.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace flattening
{
namespace
{
/// Triangles. A larger piece has work for all threads by itself.
constexpr std::size_t largePiece = 20000;
/// Triangles of small pieces that are flattened at a time: half a second on two threads, since a
/// caller that is none of these threads is asked only in between whether to go on.
constexpr std::size_t trianglesTogether = 2 * largePiece;

Status cancelled()
{
  return { StatusCode::Cancelled, "cancelled", {} };
}

/// One past the last of the pieces from a first one on that are flattened at a time.
std::size_t endOfSmallPieces(const std::vector<WiredPiece>& pieces, std::size_t first)
{
  std::size_t sum = 0;
  std::size_t last = first;
  for (; last < pieces.size(); ++last)
  {
    const std::size_t triangles = pieces[last].piece.triangles.size();
    sum += triangles;
    if (triangles > largePiece || sum > trianglesTogether)
    {
      break;
    }
  }
  return std::max(last, first + 1);
}

/// Calls body(p, execution) for each piece, small ones at a time where there are threads; a search
/// that counts work gives none. \return the status of the first that is not Ok, after which no
/// others are begun
template <typename Body>
Status forEachPiece(const std::vector<WiredPiece>& pieces, const Execution& execution,
  const char* phase, const Body& body)
{
  const auto count = static_cast<double>(pieces.size());
  Status status;
  for (std::size_t first = 0, last = 0; first < pieces.size() && status.ok(); first = last)
  {
    last = execution.parallel ? endOfSmallPieces(pieces, first) : first + 1;
    const double begin = static_cast<double>(first) / count;
    execution.report(begin, phase);
    if (execution.cancelled())
    {
      return cancelled();
    }
    if (last - first == 1)
    {
      status = body(first, execution.part(begin, static_cast<double>(last) / count));
      continue;
    }
    std::vector<Status> outcomes(last - first);
    const Execution inner = execution.nestedExecution();
    execution.forEachTask(
      static_cast<Index>(outcomes.size()), [&](Index k) { outcomes[k] = body(first + k, inner); });
    const auto bad = std::find_if(
      outcomes.begin(), outcomes.end(), [](const Status& outcome) { return !outcome.ok(); });
    status = bad == outcomes.end() ? Status() : *bad;
  }
  return status;
}

/// Half-edges of the piece's wires whose length is promised, one an edge.
Indices rigidHalfedges(const WireNetwork& network, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options)
{
  const bool free = options.boundary == BoundaryMode::Free;
  Indices edges;
  for (const WireEdge& edge : network.edges)
  {
    if (holdsLength(edge, curves, free) &&
      !isElastic(edge.curve, curves, options.boundaryTolerance))
    {
      edges.push_back(network.halfedge[edge.side]);
    }
  }
  return edges;
}

/// Values per element of a piece, to those of the cut surface.
template <class Value>
void scatter(const std::vector<Value>& values, const Indices& elements, std::vector<Value>& all)
{
  for (std::size_t k = 0; k < elements.size(); ++k)
  {
    all[elements[k]] = values[k];
  }
}

/// Each piece by itself: where pieces are not arranged they may well lie on each other.
BoundaryOverlaps overlapsOf(const Piece& piece, const Points2& positions)
{
  BoundaryOverlaps overlaps = countBoundaryOverlaps(piece.mesh, positions, mostListedOverlaps);
  const auto onCutSurface = [&piece](Index h) { return 3 * piece.triangles[h / 3] + h % 3; };
  for (auto& pair : overlaps.listed)
  {
    pair = { onCutSurface(pair[0]), onCutSurface(pair[1]) };
  }
  return overlaps;
}

/// Which triangles are out of limit, and the wire along which most of their area lies.
void noteLimits(const Piece& piece, const TriangleFrames& frames, ClothReport& report)
{
  std::map<Index, double> along; // by curve, none: the boundary
  for (std::size_t t = 0; t < piece.triangles.size(); ++t)
  {
    if (!report.threads.outOfLimit[t])
    {
      continue;
    }
    report.outOfLimit.push_back(piece.triangles[t]);
    for (Index h = 3 * static_cast<Index>(t); h < 3 * static_cast<Index>(t) + 3; ++h)
    {
      const Index curve = piece.curveOfHalfedge[h];
      if (curve != none || piece.mesh.twin(h) == none)
      {
        along[curve] += frames[t].area;
      }
    }
  }
  const auto most = std::max_element(
    along.begin(), along.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most != along.end())
  {
    report.limitingCurve = most->first;
    report.limitedByBoundary = most->first == none;
  }
  if (report.threads.worstTriangle != none)
  {
    const Index worst = piece.triangles[report.threads.worstTriangle];
    const auto place = std::find(report.outOfLimit.begin(), report.outOfLimit.end(), worst);
    std::rotate(report.outOfLimit.begin(), place, place + 1);
  }
}

/// What the threads of a piece do, which lies on its cloth.
void measureCloth(const WiredPiece& wired, const Points2& positions, const ClothOptions& options,
  ClothReport& report, std::vector<ThreadStrain>& all)
{
  const Piece& piece = wired.piece;
  const std::vector<ThreadStrain> strains =
    measureThreads(wired.measures->frames, piece.mesh.triangles(), positions);
  scatter(strains, piece.triangles, all);
  report.threads = summarizeThreads(wired.measures->frames, strains, options.material);
  noteLimits(piece, wired.measures->frames, report);
}

void measurePiece(const std::vector<FeatureCurve>& curves, const FlatteningOptions& options,
  const Execution& execution, bool only, WiredPiece& wired, PieceSolution& flat,
  FlatteningResult& result)
{
  const Piece& piece = wired.piece;
  if (!wired.measures)
  {
    wired.measures = measureSurface(piece.mesh, execution);
  }
  scatter(surfaceDevelopability(piece.mesh, wired.measures->angles), piece.vertices,
    result.developability);
  Points2 positions;
  positions.reserve(piece.vertices.size());
  for (Index v : piece.vertices)
  {
    positions.push_back(result.positions[v]);
  }
  const Indices edges = rigidHalfedges(networkOf(wired, flat), curves, options);
  FlatteningQuality quality =
    measureFlattening(piece.mesh, *wired.measures, positions, edges, execution);
  if (only)
  {
    result.triangles = std::move(quality.triangles);
  }
  else
  {
    scatter(quality.triangles, piece.triangles, result.triangles);
  }
  if (flat.report.cloth)
  {
    measureCloth(wired, positions, *options.cloth, *flat.report.cloth, result.threads);
  }
  for (Index& t : quality.summary.flipped)
  {
    t = piece.triangles[t];
  }
  flat.report.quality = std::move(quality.summary);
  flat.report.overlaps = overlapsOf(piece, positions);
}

/// What the report of a piece says of curves.
void addToCurves(const PieceReport& report, FlatteningResult& result)
{
  const CutSurface& cut = *result.cut;
  const std::vector<double>& sensitivity = report.advice.sensitivity;
  for (std::size_t c = 0; c < sensitivity.size(); ++c)
  {
    result.curves[c].sensitivity += sensitivity[c];
  }
  for (Index c : report.released)
  {
    result.curves[c].released = true;
  }
  for (Index h : report.closedEdges)
  {
    // Both sides are in the list.
    result.curves[cut.curveOfHalfedge[h]].closedLength += 0.5 * cut.mesh.length(h);
  }
  noteClosedEdges(cut.mesh, report.closedEdges, result.wires);
}

/// Measures a result whose positions and wires are in place: triangles, developability, wires,
/// curves and pieces, whose reports it takes out of the flat pieces and judges. The status becomes
/// that of the worst piece. Measures of the surface stay with the pieces. \return whether the run
/// was cancelled
Status measureResult(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution, std::vector<WiredPiece>& pieces,
  std::vector<PieceSolution>& flat, FlatteningResult& result)
{
  const CutSurface& cut = *result.cut;
  const bool only = pieces.size() == 1;
  if (!only)
  {
    result.triangles.resize(cut.mesh.triangleCount());
  }
  if (options.cloth)
  {
    result.threads.resize(cut.mesh.triangleCount());
  }
  result.developability.assign(cut.mesh.vertexCount(), 0.0);
  for (Wire& wire : result.wires)
  {
    measureWire(cut, result.positions, wire);
  }
  result.curves = summarizeCurves(mesh, cut, curves, result.wires);
  Status status =
    forEachPiece(pieces, execution, "Measuring quality", [&](std::size_t p, const Execution& part) {
      measurePiece(curves, options, part, only, pieces[p], flat[p], result);
      return Status();
    });
  if (!status.ok())
  {
    return status;
  }
  for (PieceSolution& piece : flat)
  {
    addToCurves(piece.report, result);
    const auto p = static_cast<Index>(result.pieces.size());
    result.pieces.push_back(std::move(piece.report));
    judgePiece(cut, curves, options, p, result);
    const Status& outcome = result.pieces[p].status;
    if (severity(outcome.code) > severity(result.status.code))
    {
      result.status = outcome;
    }
  }
  measureCuts(cut, result.pieces);
  return {};
}

/// Tolerances and eases of curves whose length is free.
Status checkFreeCurves(const std::vector<FeatureCurve>& curves, const FlatteningOptions& options)
{
  Indices free;
  for (std::size_t c = 0; c < curves.size() && options.boundary == BoundaryMode::Free; ++c)
  {
    const FeatureCurve& curve = curves[c];
    const bool eased = curve.ease.fraction != 0.0 ||
      std::any_of(options.eases.begin(), options.eases.end(),
        [&curve](const CurveEase& ease) { return ease.curve == curve.name; });
    if (curve.opens() && (curve.tolerance > 0.0 || eased))
    {
      free.push_back(static_cast<Index>(c));
    }
  }
  return free.empty() ? Status()
                      : Status{ StatusCode::InvalidOption,
                          "a free boundary leaves the sides of " + quotedNames(curves, free) +
                            " any length, and these have a tolerance or an ease",
                          { ElementKind::Curves, free },
                          { { Remedy::Give, "an exact boundary, or neither of them" } } };
}

/// By how much the elastic curves are longer in a flat piece than on the surface, as fractions.
CurveStretches stretchesIn(
  const WireNetwork& network, const Points2& positions, const std::vector<FeatureCurve>& curves)
{
  std::vector<double> rest(curves.size(), 0.0);
  std::vector<double> flat(curves.size(), 0.0);
  for (const WireEdge& edge : network.edges)
  {
    if (edge.curve != none && curves[edge.curve].tolerance > 0.0)
    {
      rest[edge.curve] += edge.length;
      flat[edge.curve] += (positions[edge.to] - positions[edge.from]).norm();
    }
  }
  CurveStretches stretches(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (rest[c] > 0.0)
    {
      stretches[c] = std::clamp(flat[c] / rest[c] - 1.0, -curves[c].tolerance, curves[c].tolerance);
    }
  }
  return stretches;
}

/// Each piece chooses the lengths of its elastic curves by itself, but what is sewn together must
/// be equally long: decides for the mean where a curve lies in several pieces.
/// \return what is decided, by curve; empty where all pieces agree
CurveStretches meanStretches(const PieceStretches& pieces)
{
  CurveStretches decided(pieces.empty() ? 0 : pieces.front().size());
  bool agree = true;
  for (std::size_t c = 0; c < decided.size(); ++c)
  {
    std::vector<double> stretches;
    for (const CurveStretches& piece : pieces)
    {
      if (piece[c])
      {
        stretches.push_back(*piece[c]);
      }
    }
    if (stretches.size() < 2)
    {
      continue;
    }
    const auto [least, most] = std::minmax_element(stretches.begin(), stretches.end());
    const double sum = std::accumulate(stretches.begin(), stretches.end(), 0.0);
    decided[c] = sum / static_cast<double>(stretches.size());
    // What rounding leaves of one length is no disagreement.
    agree = agree && *most - *least <= 1e-13;
  }
  return agree ? CurveStretches() : decided;
}

/// Flattens all pieces, those that share elastic curves anew with common lengths. \return the first
/// error
Status flattenPieces(const PieceSettings& settings, const Execution& execution,
  std::vector<WiredPiece>& pieces, std::vector<PieceSolution>& flat)
{
  const std::size_t curves = settings.curves.size();
  std::vector<const Piece*> all;
  for (const WiredPiece& wired : pieces)
  {
    all.push_back(&wired.piece);
  }
  PieceStretches eased;
  Status status = decideEases(settings.options.eases, settings.curves, settings.cut, all, eased);
  if (!status.ok())
  {
    return status;
  }
  flat.resize(pieces.size());
  const auto flatten = [&](std::size_t p, CurveRules rules, const Execution& part) {
    rules.freeBoundary = settings.options.boundary == BoundaryMode::Free;
    rules.boundaryTolerance = settings.options.boundaryTolerance;
    for (std::size_t c = 0; !eased.empty() && c < curves; ++c)
    {
      rules.stretch.resize(curves);
      rules.stretch[c] = eased[p][c] ? eased[p][c] : rules.stretch[c];
    }
    PieceSolution solution = flattenPiece(pieces[p], settings, rules, part);
    solution.secondsWires += flat[p].secondsWires;
    solution.secondsInterior += flat[p].secondsInterior;
    flat[p] = std::move(solution);
    const Status& outcome = flat[p].report.status;
    return outcome.refused() ? outcome : Status();
  };
  status = forEachPiece(pieces, execution.part(0.05, 0.85), "Flattening pieces",
    [&flatten](std::size_t p, const Execution& part) { return flatten(p, {}, part); });
  if (!status.ok() || settings.options.scheme == Scheme::LeastSquaresConformal)
  {
    return status;
  }
  PieceStretches stretches;
  for (std::size_t p = 0; p < flat.size(); ++p)
  {
    stretches.push_back(
      stretchesIn(networkOf(pieces[p], flat[p]), flat[p].positions, settings.curves));
    for (std::size_t c = 0; !eased.empty() && c < curves; ++c)
    {
      stretches[p][c] = eased[p][c] ? std::nullopt : stretches[p][c]; // decided already
    }
  }
  const CurveStretches decided = meanStretches(stretches);
  for (std::size_t p = 0; p < flat.size() && !decided.empty() && status.ok(); ++p)
  {
    bool shares = false;
    for (std::size_t c = 0; c < curves; ++c)
    {
      shares = shares || (decided[c] && stretches[p][c]);
    }
    if (shares)
    {
      CurveRules rules;
      rules.stretch = decided;
      status = flatten(p, std::move(rules), execution.part(0.85, 0.85));
    }
  }
  return status;
}

/// Indices in a piece of the two ends of its grainline: of the wires of its first key curve the one
/// with the most vertices.
std::array<Index, 2> findGrain(
  const std::vector<Wire>& wires, Index pieceId, const Indices& localVertex)
{
  const Wire* grain = nullptr;
  for (const Wire& wire : wires)
  {
    if (wire.piece == pieceId && wire.curve != none && wire.type == CurveType::Key &&
      (!grain || (wire.curve == grain->curve && wire.vertices.size() > grain->vertices.size())))
    {
      grain = &wire;
    }
  }
  if (!grain || grain->vertices.front() == grain->vertices.back())
  {
    return { none, none };
  }
  return { localVertex[grain->vertices.front()], localVertex[grain->vertices.back()] };
}

/// The positions of all pieces where they end up.
std::vector<Points2> finalPositions(const std::vector<WiredPiece>& pieces,
  const FlatteningOptions& options, const FlatteningResult& result,
  std::vector<PieceSolution>& flat)
{
  std::vector<ArrangementPiece> arrangement(pieces.size());
  Indices local(result.cut->mesh.vertexCount(), none);
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const Indices& vertices = pieces[p].piece.vertices;
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
      local[vertices[k]] = static_cast<Index>(k);
    }
    arrangement[p].positions = std::move(flat[p].positions);
    arrangement[p].upright = flat[p].report.cloth.has_value(); // on its cloth
    arrangement[p].grain = findGrain(result.wires, static_cast<Index>(p), local);
  }
  if (options.arrange)
  {
    return arrangePieces(arrangement, options.spacing);
  }
  std::vector<Points2> placed;
  for (ArrangementPiece& piece : arrangement)
  {
    placed.push_back(std::move(piece.positions));
  }
  return placed;
}

/// Lays the flat pieces beside each other where the options want it, and puts positions,
/// wire-patches, numbered through all pieces, and connectors into the result. Takes the positions
/// out of the solutions.
void placePieces(const std::vector<WiredPiece>& pieces, const FlatteningOptions& options,
  std::vector<PieceSolution>& flat, FlatteningResult& result)
{
  const TriangleMesh& mesh = result.cut->mesh;
  const std::vector<Points2> placed = finalPositions(pieces, options, result, flat);
  result.positions.assign(mesh.vertexCount(), Point2::Zero());
  result.patchOfTriangle.assign(mesh.triangleCount(), none);
  Index firstPatch = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const Piece& piece = pieces[p].piece;
    const WireNetwork& network = networkOf(pieces[p], flat[p]);
    for (std::size_t k = 0; k < piece.vertices.size(); ++k)
    {
      result.positions[piece.vertices[k]] = placed[p][k];
    }
    for (std::size_t t = 0; t < piece.triangles.size(); ++t)
    {
      result.patchOfTriangle[piece.triangles[t]] = firstPatch + network.patchOfTriangle[t];
    }
    for (Index& patch : flat[p].report.warpingOrder)
    {
      patch += firstPatch;
    }
    firstPatch += network.patchCount;
    const std::vector<Wire> connectors = traceConnectors(network, piece, static_cast<Index>(p));
    result.wires.insert(result.wires.end(), connectors.begin(), connectors.end());
  }
}

/// Stage by stage. \param keep whether the cache outlives the run \return the error that ends it
Status flattenStages(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& requested, const Execution& execution, bool keep, FlatteningCache& kept,
  FlatteningResult& result)
{
  Stopwatch watch;
  Status status = checkOptions(requested);
  status = status.ok() ? checkFreeCurves(curves, requested) : status;
  status = status.ok() ? checkWeights(requested.isometric.weights, mesh.triangleCount()) : status;
  if (!status.ok())
  {
    return status;
  }
  const FlatteningOptions options = withEnergy(requested);
  execution.report(0.0, "Cutting darts and seams");
  CurveLabels labels = labelHalfedges(mesh, curves);
  if (!labels.status.ok())
  {
    return labels.status;
  }
  if (!keep || !kept.isValidFor(mesh, labels, options.skipClosed))
  {
    kept.renew(mesh, std::move(labels), options.skipClosed, keep);
  }
  if (!kept.topology.ok() || execution.cancelled())
  {
    return kept.topology.ok() ? cancelled() : kept.topology;
  }
  std::vector<PieceSolution> flat;
  status = flattenPieces({ *kept.cut, curves, options, keep }, execution, kept.pieces, flat);
  if (!status.ok())
  {
    return status;
  }
  for (const PieceSolution& piece : flat)
  {
    result.seconds.wires += piece.secondsWires;
    result.seconds.interior += piece.secondsInterior;
  }
  result.cut = kept.cut;
  result.leftOut = kept.leftOut;
  result.wires = traceWires(mesh, *kept.cut, curves);
  placePieces(kept.pieces, options, flat, result);
  Stopwatch qualityWatch;
  status =
    measureResult(mesh, curves, options, execution.part(0.9, 1.0), kept.pieces, flat, result);
  if (!status.ok())
  {
    return status;
  }
  result.seconds.quality = qualityWatch.seconds();
  result.seconds.total = watch.seconds();
  execution.report(1.0, "Done");
  return {};
}
}

FlatteningResult flattenSurface(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution, FlatteningCache* cache)
{
  FlatteningResult result = withinMemory([&] {
    FlatteningCache own;
    FlatteningResult flat;
    Status error =
      flattenStages(mesh, curves, options, execution, cache != nullptr, cache ? *cache : own, flat);
    if (!error.ok())
    {
      flat = {};
      flat.status = std::move(error);
    }
    return flat;
  });
  if (result.status.code == StatusCode::OutOfMemory && cache)
  {
    *cache = {}; // it may be incomplete
  }
  return result;
}
}
