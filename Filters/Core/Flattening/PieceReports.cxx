// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceReports.h"

#include "Base/Types.h"
#include "Flattening/PieceWires.h"
#include "Wires/KeyCurveLocks.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace flattening
{
namespace
{
/// A bend of 2 % turns the ends of a curve by 5 degrees from its line, the least that pattern
/// makers tell from the straight grain; a line along mesh edges may waver by as much.
constexpr double straightGrain = 0.02;

/// See PieceReport::otherEnergy.
std::string otherEnergy(const PieceContext& context, const PieceSolution& flat)
{
  if (!flat.isometric || flat.clothSolved ||
    *flat.report.energyUsed == context.options.isometric.energy.kind)
  {
    return {};
  }
  return *flat.report.energyUsed == DistortionEnergyKind::SymmetricDirichlet
    ? "the symmetric Dirichlet energy was used, since the chosen one folds triangles or crushes "
      "them"
    : "no energy of the isometric scheme keeps triangles from folding; the piece lies where the "
      "global scheme has put it";
}

/// What was done instead of what was requested.
std::vector<std::string> fallbacks(const PieceContext& context, const PieceSolution& flat)
{
  std::vector<std::string> all;
  const FlatteningOptions& options = context.options;
  if (options.angles.method == AngleMethod::Sequential && flat.angles.method == AngleMethod::Newton)
  {
    all.emplace_back("the wires were solved by Newton's method: the sequential one of the paper "
                     "cannot choose the lengths of elastic curves and connectors");
  }
  if (flat.report.repaired)
  {
    all.emplace_back("the patches could not all be closed one after the other; the wires have the "
                     "nearest angles that close");
  }
  if (!flat.report.otherEnergy.empty())
  {
    all.push_back(flat.report.otherEnergy);
  }
  if (flat.fromConvexStart)
  {
    all.emplace_back(context.exceedsPlanarArea()
        ? "the isometric scheme started from a convex map: a plane has no room for the piece"
        : "the isometric scheme started from a convex map: the wires' own angles led to a worse "
          "piece");
  }
  if (flat.grain && flat.grain->missing)
  {
    all.emplace_back("none of the curves that are to give the grain is one of the piece; its warp "
                     "lies by its upright");
  }
  if (flat.grain && flat.grain->bend > straightGrain)
  {
    all.emplace_back(quotedNames(context.curves, { flat.grain->curve }) +
      ", which gives the grain, bends by " + shortNumber(100.0 * flat.grain->bend) +
      " % of its length; the grain follows the line between its ends");
  }
  // A tube that is only mapped keeps no length.
  const bool mapped = options.scheme == Scheme::Isometric && !flat.isometric;
  const double error = flat.isometric
    ? largestLengthError(flat.problem, stretchedLengths(flat.problem, flat.isometric->stretch),
        flat.positions, false)
    : largestLengthError(flat.problem, flat.angles.length, flat.positions, true);
  if (!mapped && !(error <= options.lengthTolerance))
  {
    all.emplace_back("the last correction of the wires' lengths ended with an edge off by " +
      shortNumber(error) + " of its length; the piece lies as it left it");
  }
  if (!flat.freeDarts.empty())
  {
    all.push_back("darts whose legs cannot be made to fold on each other keep free ones: " +
      quotedNames(context.curves, flat.freeDarts));
  }
  if (flat.strainOfLegs > 0.0)
  {
    all.push_back("legs of darts that fold on each other leave a strain of " +
      percent(flat.strainOfLegs) + ", free ones would leave " + percent(flat.strainOfFreeLegs));
  }
  return all;
}

/// Curves that a message names.
constexpr std::ptrdiff_t maximumNamed = 5;

/// A piece of which more than this share of the area is beyond its material's limits misses them;
/// less is left to corners, where exact lengths decide.
constexpr double toleratedShareOutOfLimit = 0.05;

std::string quoted(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "\"" : ", \"") + name + "\"";
  }
  return text;
}

/// What is wrong with the first name that is a curve's with a colon and no angle after it.
std::string describeWrongAngle(
  const std::vector<FeatureCurve>& curves, const std::vector<std::string>& names)
{
  const auto known = [&curves](const std::string& name) {
    return std::any_of(curves.begin(), curves.end(),
      [&name](const FeatureCurve& curve) { return curve.name == name; });
  };
  for (const std::string& name : names)
  {
    const std::size_t colon = name.rfind(':');
    if (colon != std::string::npos && known(name.substr(0, colon)) && !known(name))
    {
      return ", and \"" + name.substr(colon + 1) + "\" is not an angle in degrees";
    }
  }
  return {};
}

Status missingGrain(
  const std::vector<FeatureCurve>& curves, const ClothOptions& cloth, const GrainReport& grain)
{
  const char* const none =
    cloth.grainCurves.size() == 1 ? " is not a curve of the piece" : " are not curves of the piece";
  Status status{ StatusCode::MissingGrain,
    quoted(cloth.grainCurves) + none + " that its grain can follow" +
      describeWrongAngle(curves, cloth.grainCurves) + "; its warp lies by its upright",
    {}, {} };
  if (!grain.candidates.empty())
  {
    const auto named = std::min(maximumNamed, static_cast<std::ptrdiff_t>(grain.candidates.size()));
    status.remedies.emplace_back(Remedy::NameGrain,
      quotedNames(curves, { grain.candidates.begin(), grain.candidates.begin() + named }));
  }
  status.remedies.emplace_back(Remedy::GiveGrainAngle);
  return status;
}

/// By how much one measure is beyond its limits, over the limit.
struct Excess
{
  std::string text;
  double size = 0.0;
};

void consider(const std::string& thread, double strain, const StrainLimits& limits, Excess& worst)
{
  const bool drawn = strain > 0.0;
  const double limit = drawn ? limits.greatest : limits.least;
  const double size = strain / limit - 1.0;
  if (size > worst.size)
  {
    worst = { thread + (drawn ? " drawn by " : " compressed by ") + percent(std::abs(strain)) +
        " where " + percent(std::abs(limit)) + " is allowed",
      size };
  }
}

/// Of the triangle farthest out.
std::string describeWorst(const ThreadStrain& strain, const ClothMaterial& material)
{
  if (!isPossible(strain))
  {
    return "turned over";
  }
  Excess worst;
  consider("its warp", strain.warp, material.warpLimits, worst);
  consider("its weft", strain.weft, material.weftLimits, worst);
  const double shear = std::abs(strain.shear);
  if (shear / material.shearLimit - 1.0 > worst.size)
  {
    worst.text = "its threads sheared by " + shortNumber(shear / degree) + " degrees where " +
      shortNumber(material.shearLimit / degree) + " are allowed";
  }
  return worst.text;
}

Status beyondLimits(const std::vector<FeatureCurve>& curves, const ClothOptions& cloth,
  const ClothReport& report, const std::vector<ThreadStrain>& threads)
{
  const Index worst = report.outOfLimit.front();
  std::string wire;
  if (report.limitingCurve != none)
  {
    wire = ", most of it along " + quotedNames(curves, { report.limitingCurve });
  }
  else if (report.limitedByBoundary)
  {
    wire = ", most of it along the boundary";
  }
  Status status{ StatusCode::BeyondLimits,
    percent(report.threads.shareOutOfLimit) +
      " of its area is beyond the limits of the material \"" + cloth.material.name + "\"" + wire +
      ": triangles " + listIds(report.outOfLimit) + ", the first of them farthest, " +
      describeWorst(threads[worst], cloth.material),
    { ElementKind::Cells, report.outOfLimit }, { Remedy::AddDarts, Remedy::DivideBySeam } };
  if (report.limitingCurve != none)
  {
    status.remedies.emplace_back(
      Remedy::ReleaseCurves, quotedNames(curves, { report.limitingCurve }));
  }
  status.remedies.emplace_back(Remedy::TakeSofterCloth);
  return status;
}

/// Errors up to this are rounding of a solution that is none the worse for it.
constexpr double roundingError = 1e-6;

/// Both ends of the worst edge of a wire, in the surface before the cut.
Indices worstEdge(const CutSurface& cut, const Points2& positions, const Wire& wire)
{
  Indices ends;
  double worst = -1.0;
  forEachEdge(wire.vertices, [&](Index a, Index b) {
    const double rest = (cut.mesh.point(b) - cut.mesh.point(a)).norm();
    const double flat = (positions[b] - positions[a]).norm();
    if (!(std::abs(flat - rest) <= worst * rest))
    {
      worst = std::abs(flat - rest) / rest;
      ends = { cut.originalVertex[a], cut.originalVertex[b] };
    }
  });
  return ends;
}

/// Which wires of a piece miss their lengths: curves, the worst first, and the boundary.
Status wrongLengths(const CutSurface& cut, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, Index piece, const FlatteningResult& result)
{
  const bool free = options.boundary == BoundaryMode::Free;
  std::map<Index, double> errors; // by curve, none: the boundary
  double worst = 0.0;
  const Wire* worstWire = nullptr;
  for (const Wire& wire : result.wires)
  {
    const double error = wire.maximumEdgeError;
    const bool elastic = isElastic(wire.curve, curves, options.boundaryTolerance);
    const bool held = holdsLength(wire.curve, curves, free);
    if (wire.piece == piece && held && !wire.connector && !elastic &&
      !(wire.resolvedEdgeError <= options.lengthTolerance))
    {
      errors[wire.curve] = std::max(errors[wire.curve], error);
      if (!worstWire || !(error <= worst))
      {
        worst = error;
        worstWire = &wire;
      }
    }
  }
  Indices off;
  for (const auto& [curve, error] : errors)
  {
    if (curve != none)
    {
      off.push_back(curve);
    }
  }
  std::stable_sort(
    off.begin(), off.end(), [&errors](Index a, Index b) { return errors[a] > errors[b]; });
  const Indices named(
    off.begin(), off.begin() + std::min(maximumNamed, static_cast<std::ptrdiff_t>(off.size())));
  std::string text;
  for (const Index c : named)
  {
    text += (text.empty() ? "" : ", ") + quotedNames(curves, { c }) + " by up to " +
      shortNumber(errors[c]);
  }
  const std::size_t more = off.size() - named.size();
  text += more > 0 ? " and " + std::to_string(more) + " more curves" : "";
  if (errors.count(none) > 0)
  {
    text += (text.empty() ? "" : ", ") + ("the boundary by up to " + shortNumber(errors[none]));
  }
  Status status{ StatusCode::LengthError,
    "wires miss the lengths of their edges (as a fraction): " + text, { ElementKind::Curves, off },
    {} };
  if (off.empty() && worstWire)
  {
    status.ids = { ElementKind::Edges, worstEdge(cut, result.positions, *worstWire) };
  }
  const PieceReport& report = result.pieces[piece];
  if (worst <= roundingError)
  {
    status.remedies.emplace_back(Remedy::AllowLengthError);
  }
  if (report.area.tube())
  {
    status.remedies.emplace_back(Remedy::SeamBetweenLoops);
  }
  if (report.wired)
  {
    status.remedies.emplace_back(
      Remedy::ReleaseCurves, off.empty() ? "a feature curve" : quotedNames(curves, named));
  }
  else if (status.remedies.empty())
  {
    status.remedies.emplace_back(Remedy::AddDarts);
  }
  return status;
}

/// Flips where an interior that does not look at them, or the scheme, is to blame first.
Status flippedTriangles(const PieceReport& report, const FlatteningOptions& options)
{
  const Indices& flipped = report.quality.flipped;
  Status status{ StatusCode::FlippedTriangles,
    std::to_string(flipped.size()) + " triangle(s) are flipped: " + listIds(flipped),
    { ElementKind::Cells, flipped }, {} };
  const bool conformal = options.scheme == Scheme::LeastSquaresConformal;
  if (!conformal && options.interior.method != InteriorMethod::AsRigidAsPossible)
  {
    status.remedies.emplace_back(Remedy::UseRigidInterior);
  }
  if (options.scheme != Scheme::Isometric)
  {
    status.remedies.emplace_back(Remedy::UseIsometricScheme);
  }
  status.remedies.emplace_back(report.area.tube() ? Remedy::SeamBetweenLoops : Remedy::AddDarts);
  if (!conformal && report.wired)
  {
    status.remedies.emplace_back(Remedy::ReleaseCurves, "feature curves there");
  }
  return status;
}

/// The cuts with a side vertex on an edge that crosses another one.
Indices crossingCuts(const CutSurface& cut, const PieceReport& report)
{
  const TriangleMesh& mesh = cut.mesh;
  std::vector<char> crossing(mesh.vertexCount(), 0);
  for (const auto& pair : report.overlaps.listed)
  {
    for (Index h : pair)
    {
      crossing[mesh.from(h)] = crossing[mesh.to(h)] = 1;
    }
  }
  Indices curves;
  for (const SeamPair& pair : cut.seamPairs)
  {
    if (crossing[mesh.from(pair.first)] || crossing[mesh.to(pair.first)] ||
      crossing[mesh.from(pair.second)] || crossing[mesh.to(pair.second)])
    {
      curves.push_back(pair.curve);
    }
  }
  sortUnique(curves);
  return curves;
}

Status overlap(const CutSurface& cut, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const PieceReport& report)
{
  Indices triangles;
  for (const auto& pair : report.overlaps.listed)
  {
    triangles.push_back(pair[0] / 3);
    triangles.push_back(pair[1] / 3);
  }
  std::string message = "the piece overlaps itself at triangles " + listIds(triangles);
  const Indices cuts = crossingCuts(cut, report);
  if (!cuts.empty())
  {
    message += ", where the sides of " + quotedNames(curves, cuts) + " cross";
  }
  if (options.preventOverlap)
  {
    message += ", since it has no convex map without folds to start from";
  }
  Status status{ StatusCode::Overlap, message, { ElementKind::Cells, triangles }, {} };
  if (options.boundary == BoundaryMode::Free && !options.preventOverlap && !options.cloth)
  {
    status.remedies.emplace_back(Remedy::PreventOverlap);
  }
  if (!cuts.empty() && !options.closeCuts)
  {
    status.remedies.emplace_back(Remedy::CloseCuts);
  }
  if (report.boundaryLoops > 1)
  {
    status.remedies.emplace_back(Remedy::SeamBetweenLoops);
  }
  status.remedies.emplace_back(Remedy::DivideBySeam);
  return status;
}

/// A piece that is not at a minimum: what is wrong with it, and what remedy fits it.
void explain(const FlatteningOptions& options, PieceReport& report)
{
  Status& status = report.status;
  const bool sequential = options.angles.method == AngleMethod::Sequential;
  const bool slow = std::any_of(status.remedies.begin(), status.remedies.end(),
    [](const SuggestedRemedy& way) { return way.remedy == Remedy::AllowRelaxationIterations; });
  if (report.boundaryLoops > 1 && !slow)
  {
    status.remedies.emplace_back(Remedy::SeamBetweenLoops);
  }
  if (report.area.deep() && !report.area.tube())
  {
    // What keeps it from a minimum is that there is no room; the verdict says where a cut helps.
    status.remedies.emplace_back(Remedy::AddDarts);
  }
  if (report.wired && !sequential && !slow)
  {
    status.remedies.emplace_back(Remedy::ReleaseCurves, "a feature curve");
  }
  if (status.remedies.empty())
  {
    status.remedies.emplace_back(Remedy::MendSlivers);
  }
  const Indices& flipped = report.quality.flipped;
  status.ids = { ElementKind::Cells, flipped };
  if (!flipped.empty())
  {
    status.message +=
      " (" + std::to_string(flipped.size()) + " triangle(s) are flipped: " + listIds(flipped) + ")";
  }
}

/// The worse status, which names the other as well.
Status together(Status worse, const Status& other)
{
  if (!other.ok())
  {
    worse.message += "; " + other.message;
    // Of a cloth that misses its limits the other defect may be the cause.
    const bool first = severity(other.code) >= severity(StatusCode::Overlap);
    SuggestedRemedies& ways = worse.remedies;
    auto place = first ? ways.begin() : ways.end();
    for (const SuggestedRemedy& way : other.remedies)
    {
      const bool known = std::any_of(ways.begin(), ways.end(), [&way](const SuggestedRemedy& one) {
        return one.remedy == way.remedy && one.subject == way.subject;
      });
      if (!known)
      {
        place = ways.insert(place, way) + 1;
      }
    }
  }
  return worse;
}
}

WireMeasures measureWires(const AngleProblem& problem, const Points2& positions)
{
  const WireNetwork& network = *problem.network;
  const std::vector<double> theta = planarAngles(problem, positions);
  std::vector<double> length = problem.length;
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    length[e] = problem.held[e] && problem.stretchGroup[e] == none
      ? length[e]
      : (positions[edge.to] - positions[edge.from]).norm();
  }
  return { angleObjective(problem, theta), closureResidual(network, theta, length) };
}

void reportPiece(const PieceContext& context, PieceSolution& solution)
{
  const Piece& piece = context.piece;
  const WireNetwork& network = context.network;
  PieceReport& report = solution.report;
  report.triangles = piece.mesh.triangleCount();
  report.vertices = piece.mesh.vertexCount();
  report.wirePatches = network.patchCount;
  report.wireNodes = network.nodeCount();
  report.freeWireNodes = network.nodeCount();
  report.boundaryLoops = network.boundaryLoops;
  report.wired = std::any_of(piece.curveOfHalfedge.begin(), piece.curveOfHalfedge.end(),
    [](Index curve) { return curve != none; });
  report.status = solution.status;
  if (context.area)
  {
    report.area = *context.area;
    const auto onCutSurface = [&piece](Indices& vertices) {
      for (Index& v : vertices)
      {
        v = piece.vertices[v];
      }
    };
    onCutSurface(report.area.cut);
    std::for_each(report.area.openings.begin(), report.area.openings.end(), onCutSurface);
  }
  if (solution.status.refused())
  {
    return;
  }
  if (solution.grain)
  {
    const ClothMaterial& material = context.options.cloth->material;
    report.cloth.emplace();
    report.cloth->oneWay = material.oneWay;
    report.cloth->shearLimit = material.shearLimit;
    report.cloth->grain = *solution.grain;
    report.cloth->solved = solution.clothSolved;
  }
  const WireMeasures measures = measureWires(solution.problem, solution.positions);
  report.objective = measures.objective;
  report.closureResidual = measures.closure;
  if (context.options.scheme == Scheme::LeastSquaresConformal)
  {
    return;
  }
  const AngleConstraints constraints(solution.problem);
  report.freeWireNodes = constraints.freeCount();
  report.constraints = constraints.rowCount();
  report.released = solution.rules.released;
  report.solverUsed = solution.angles.method;
  report.iterations = solution.angles.iterations;
  report.history = solution.angles.history;
  if (solution.isometric)
  {
    const IsometricSolution& isometric = *solution.isometric;
    report.otherEnergy = otherEnergy(context, solution);
    report.iterations = isometric.iterations;
    report.isometricHistory = isometric.history;
    report.distortionEnergy = isometric.distortionEnergy;
    report.angleEnergy = isometric.angleEnergy;
  }
  report.fallbacks = fallbacks(context, solution);
}

void judgePiece(const CutSurface& cut, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, Index piece, FlatteningResult& result)
{
  PieceReport& report = result.pieces[piece];
  if (report.status.code == StatusCode::NotConverged)
  {
    explain(options, report);
  }
  const QualitySummary& quality = report.quality;
  const bool keepsLengths = options.scheme != Scheme::LeastSquaresConformal;
  if (keepsLengths && !(quality.resolvedEdgeLengthError <= options.lengthTolerance) &&
    severity(StatusCode::LengthError) > severity(report.status.code))
  {
    report.status = together(wrongLengths(cut, curves, options, piece, result), report.status);
  }
  else if (report.status.ok() && !quality.flipped.empty())
  {
    report.status = flippedTriangles(report, options);
  }
  else if (report.status.ok() && report.overlaps.count > 0)
  {
    report.status = overlap(cut, curves, options, report);
  }
  const auto note = [&report](const Status& defect) {
    report.status = report.status.ok() ? defect : together(report.status, defect);
  };
  if (report.cloth && report.cloth->grain.missing)
  {
    note(missingGrain(curves, *options.cloth, report.cloth->grain));
  }
  if (report.cloth && report.cloth->threads.shareOutOfLimit > toleratedShareOutOfLimit)
  {
    note(beyondLimits(curves, *options.cloth, *report.cloth, result.threads));
  }
}
}
