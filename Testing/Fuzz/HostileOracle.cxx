// SPDX-License-Identifier: BSD-3-Clause
#include "HostileCase.h"
#include "Surface/SurfaceHealing.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <sstream>

namespace hostile
{
namespace
{
constexpr double lengthPromise = 1e-9;

/// Collects the first fault only: what follows is mostly its consequence.
class Checks
{
public:
  void require(bool holds, const std::string& fault)
  {
    if (!holds && this->Fault.empty())
    {
      this->Fault = fault;
    }
  }
  void finite(const char* name, std::initializer_list<double> values)
  {
    for (const double value : values)
    {
      this->require(std::isfinite(value), std::string(name) + " is not finite");
    }
  }
  const std::string& fault() const { return this->Fault; }

private:
  std::string Fault;
};

void checkStatus(const Status& status, Checks& checks)
{
  checks.require(!status.ok() || status.message.empty(), "an Ok with a message");
  checks.require(status.ok() || status.code == StatusCode::Cancelled || !status.remedies.empty(),
    std::string(statusName(status.code)) + " without a way out");
  checks.require(status.ok() || !status.message.empty(),
    std::string(statusName(status.code)) + " without words");
}

void checkRefusal(const FlatteningResult& result, Checks& checks)
{
  checks.require(result.positions.empty() && result.pieces.empty() && result.wires.empty() &&
      result.triangles.empty() && result.curves.empty() && result.cut->mesh.triangleCount() == 0,
    "a refusal with a result");
}

double flatLength(const FlatteningResult& result, Index a, Index b)
{
  return std::hypot(result.positions[b].x() - result.positions[a].x(),
    result.positions[b].y() - result.positions[a].y());
}

/// Whether a piece breaks no promise, or one of its cloth alone.
bool isSound(const PieceReport& piece)
{
  return severity(piece.status.code) < severity(StatusCode::Overlap);
}

/// The promise on lengths, edge by edge, from the points and positions alone.
void checkLengths(
  const std::vector<FeatureCurve>& curves, const FlatteningResult& result, Checks& checks)
{
  const TriangleMesh& mesh = result.cut->mesh;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    const Index curve = result.cut->curveOfHalfedge[h];
    if (curve == none && mesh.twin(h) != none)
    {
      continue;
    }
    const double length = flatLength(result, mesh.from(h), mesh.to(h));
    const double error = std::abs(length - mesh.length(h)) / mesh.length(h);
    const double band = curve == none ? 0.0 : curves[curve].tolerance;
    // Half a unit in the last place of the coordinates at both ends.
    const double farthest =
      std::max(result.positions[mesh.from(h)].norm(), result.positions[mesh.to(h)].norm());
    const double rounding = std::numeric_limits<double>::epsilon() * farthest / mesh.length(h);
    const PieceReport& piece = result.pieces[result.cut->pieceOfTriangle[h / 3]];
    if (isSound(piece) && !(error <= band + lengthPromise + rounding))
    {
      std::ostringstream text;
      text << "half-edge " << h << " misses its length by " << error << " in a piece that is Ok";
      checks.require(false, text.str());
      return;
    }
  }
}

/// Counts the triangles that are clearly turned over.
void checkFlips(const FlatteningResult& result, Checks& checks)
{
  std::vector<Index> clear(result.pieces.size(), 0);
  for (Index t = 0; t < result.cut->mesh.triangleCount(); ++t)
  {
    const Triangle& c = result.cut->mesh.triangle(t);
    const Point2 u = result.positions[c[1]] - result.positions[c[0]];
    const Point2 v = result.positions[c[2]] - result.positions[c[0]];
    const double size = std::max({ u.norm(), v.norm(), (v - u).norm() });
    clear[result.cut->pieceOfTriangle[t]] += u.x() * v.y() - u.y() * v.x() < -1e-9 * size * size;
  }
  for (std::size_t p = 0; p < result.pieces.size(); ++p)
  {
    const PieceReport& piece = result.pieces[p];
    checks.require(!isSound(piece) || clear[p] == 0, "flipped triangles in a piece that is Ok");
    checks.require(clear[p] <= static_cast<Index>(piece.quality.flipped.size()),
      "more triangles are flipped than are reported");
    checks.require(piece.quality.flipped.empty() || piece.quality.globalHomogeneity <= 0.0,
      "E_h is positive in spite of a flip");
  }
}

double side(const Point2& a, const Point2& b, const Point2& p)
{
  const Point2 along = (b - a).normalized();
  return along.x() * (p - a).y() - along.y() * (p - a).x();
}

/// Boundary edges that cross by a clear distance, each with each.
void checkOverlaps(const FlatteningResult& result, Checks& checks)
{
  const TriangleMesh& mesh = result.cut->mesh;
  std::vector<Indices> borders(result.pieces.size());
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) == none)
    {
      borders[result.cut->pieceOfTriangle[h / 3]].push_back(h);
    }
  }
  for (std::size_t p = 0; p < borders.size(); ++p)
  {
    if (!isSound(result.pieces[p]) || borders[p].size() > 400)
    {
      continue;
    }
    Eigen::AlignedBox2d box;
    for (const Index h : borders[p])
    {
      box.extend(result.positions[mesh.from(h)]);
    }
    const double clear = 1e-5 * box.diagonal().norm();
    const auto apart = [&](const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
      const double first = side(a, b, c);
      const double second = side(a, b, d);
      return std::min(std::abs(first), std::abs(second)) > clear && (first < 0.0) != (second < 0.0);
    };
    for (std::size_t i = 0; i < borders[p].size(); ++i)
    {
      for (std::size_t k = i + 1; k < borders[p].size(); ++k)
      {
        const Point2& a = result.positions[mesh.from(borders[p][i])];
        const Point2& b = result.positions[mesh.to(borders[p][i])];
        const Point2& c = result.positions[mesh.from(borders[p][k])];
        const Point2& d = result.positions[mesh.to(borders[p][k])];
        checks.require(
          !apart(a, b, c, d) || !apart(c, d, a, b), "an overlap in a piece that is Ok");
      }
    }
  }
}

void checkNumbers(const FlatteningResult& result, Checks& checks)
{
  for (const Point2& p : result.positions)
  {
    checks.require(p.allFinite(), "a position is not finite");
  }
  for (const TriangleQuality& triangle : result.triangles)
  {
    checks.finite("a measure of a triangle",
      { triangle.areaRatio, triangle.homogeneity, triangle.aspectRatio, triangle.angleError });
  }
  for (const double value : result.developability)
  {
    checks.finite("a developability", { value });
  }
  for (const Wire& wire : result.wires)
  {
    checks.finite("a wire's length", { wire.flatLength, wire.restLength, wire.maximumEdgeError });
  }
  for (const CurveReport& curve : result.curves)
  {
    checks.finite("a measure of a curve",
      { curve.flatLength, curve.restLength, curve.error, curve.sensitivity });
  }
  for (const PieceReport& piece : result.pieces)
  {
    const QualitySummary& quality = piece.quality;
    checks.finite("a measure of a piece",
      { piece.objective, piece.closureResidual, piece.distortionEnergy, piece.angleEnergy,
        piece.cutLength, quality.edgeLengthError, quality.maximumEdgeLengthError,
        quality.angleError, quality.globalHomogeneity, quality.globalAspectRatio, quality.areaError,
        quality.strainP95, quality.rigidEnergy });
  }
}

/// What a cloth does, where there is one.
void checkThreads(const FlatteningOptions& options, const FlatteningResult& result, Checks& checks)
{
  checks.require(result.threads.empty() || result.threads.size() == result.triangles.size(),
    "strains of another number than the triangles");
  for (const ThreadStrain& strain : result.threads)
  {
    checks.finite("a strain of threads", { strain.warp, strain.weft, strain.shear });
  }
  for (const PieceReport& piece : result.pieces)
  {
    const bool told = piece.status.message.find("material") != std::string::npos;
    checks.require(!options.cloth || piece.cloth || told || !isSound(piece),
      "a piece without its cloth that does not say so");
    checks.require(options.cloth || !piece.cloth, "a cloth that nobody asked for");
    if (piece.cloth)
    {
      const ClothSummary& threads = piece.cloth->threads;
      checks.finite("a measure of a cloth",
        { threads.warpRms, threads.weftRms, threads.shearRms, piece.cloth->grain.angle });
      for (const double share : { threads.shareOutOfLimit, threads.shareOver5Percent })
      {
        checks.require(share >= 0.0 && share <= 1.0, "a share that is none");
      }
      checks.require((threads.shareOutOfLimit > 0.0) == !piece.cloth->outOfLimit.empty(),
        "a share out of limit without triangles");
    }
  }
}

void checkResult(const std::vector<FeatureCurve>& curves, const FlatteningOptions& options,
  const FlatteningResult& result, Checks& checks)
{
  checkStatus(result.status, checks);
  if (result.status.refused())
  {
    checkRefusal(result, checks);
    return;
  }
  const auto vertices = static_cast<std::size_t>(result.cut->mesh.vertexCount());
  const auto triangles = static_cast<std::size_t>(result.cut->mesh.triangleCount());
  checks.require(triangles > 0 && result.positions.size() == vertices &&
      result.developability.size() == vertices && result.triangles.size() == triangles &&
      result.patchOfTriangle.size() == triangles && result.curves.size() == curves.size() &&
      static_cast<Index>(result.pieces.size()) == result.cut->pieceCount,
    "an array of the wrong size");
  if (!checks.fault().empty())
  {
    return;
  }
  bool ok = true;
  for (const PieceReport& piece : result.pieces)
  {
    checkStatus(piece.status, checks);
    checks.require(!piece.status.refused(), "a refused piece in a result");
    ok = ok && piece.status.ok();
  }
  checks.require(ok == result.status.ok(), "the status of the whole is not that of its pieces");
  checkNumbers(result, checks);
  if (options.scheme != Scheme::LeastSquaresConformal)
  {
    checkLengths(curves, result, checks);
  }
  checkThreads(options, result, checks);
  checkFlips(result, checks);
  checkOverlaps(result, checks);
}

/// What the imprint makes is a surface of the same kind and area again.
void checkImprint(const TriangleMesh& before, const TriangleMesh& after, Checks& checks)
{
  const PreparedSurface again =
    prepareSurface(after.points(), after.triangles(), CoincidentPoints::Keep);
  checks.require(again.status.ok(), "the imprinted surface: " + again.status.message);
  checks.require(eulerCharacteristic(before) == eulerCharacteristic(after),
    "the imprint has changed the surface's topology");
  double area[] = { 0.0, 0.0 };
  double rounding = 0.0;
  for (Index t = 0; t < before.triangleCount(); ++t)
  {
    area[0] += before.area(t);
  }
  for (Index t = 0; t < after.triangleCount(); ++t)
  {
    area[1] += after.area(t);
    rounding += 1e-14 * after.point(after.from(3 * t)).cwiseAbs().maxCoeff() *
      (after.length(3 * t) + after.length(3 * t + 1));
  }
  checks.require(
    std::abs(area[1] - area[0]) <= 1e-6 * area[0] + rounding, "the imprint has changed the area");
}

StatusCode goTheWay(const HostileCase& hostileCase, Checks& checks)
{
  const HealedSurface prepared =
    healSurface(hostileCase.points, hostileCase.triangles, hostileCase.coincident);
  checkStatus(prepared.status, checks);
  if (!prepared.status.ok())
  {
    return prepared.status.code;
  }
  Index questions = 0;
  Execution execution;
  if (hostileCase.cancelAt != none)
  {
    execution.cancel = [&] { return questions++ >= hostileCase.cancelAt; };
  }
  ImprintedSurface imprinted =
    imprintCurves(prepared.mesh, hostileCase.polylines, hostileCase.imprint, execution);
  checkStatus(imprinted.status, checks);
  if (!imprinted.status.ok())
  {
    return imprinted.status.code;
  }
  checkImprint(prepared.mesh, imprinted.mesh, checks);
  if (!checks.fault().empty())
  {
    return imprinted.status.code;
  }
  std::vector<FeatureCurve> curves = std::move(imprinted.curves);
  for (FeatureCurve curve : hostileCase.chains)
  {
    for (Index& v : curve.vertices)
    {
      const bool known = v >= 0 && v < static_cast<Index>(prepared.vertexOfPoint.size());
      v = known ? prepared.vertexOfPoint[v] : v;
    }
    curves.push_back(std::move(curve));
  }
  const FlatteningResult result =
    flattenSurface(imprinted.mesh, curves, hostileCase.options, execution);
  checkResult(curves, hostileCase.options, result, checks);
  return result.status.code;
}
}

Verdict tryCase(const HostileCase& hostileCase)
{
  const std::clock_t start = std::clock(); // of the processor: others may use it as well
  Checks checks;
  Verdict verdict;
  verdict.triangles = static_cast<Index>(hostileCase.triangles.size());
  verdict.code = goTheWay(hostileCase, checks);
  verdict.fault = checks.fault();
  verdict.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return verdict;
}
}
