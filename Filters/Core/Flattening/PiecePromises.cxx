// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PiecePromises.h"

#include "Base/Types.h"
#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flattening
{
namespace
{
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

Status missingGrain(
  const std::vector<FeatureCurve>& curves, const ClothOptions& cloth, const GrainReport& grain)
{
  const char* const none =
    cloth.grainCurves.size() == 1 ? " is no curve of the piece" : " are no curves of the piece";
  Status status{ StatusCode::MissingGrain,
    quoted(cloth.grainCurves) + none + " that its grain can follow; its warp lies by its upright",
    {}, {} };
  if (!grain.candidates.empty())
  {
    constexpr std::size_t most = 5;
    const auto named = static_cast<std::ptrdiff_t>(std::min(most, grain.candidates.size()));
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
  const FlatteningResult& result)
{
  const ClothReport& report = *result.pieces.back().cloth;
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
      describeWorst(result.threads[worst], cloth.material),
    { ElementKind::Cells, report.outOfLimit }, { Remedy::AddDarts, Remedy::DivideBySeam } };
  if (report.limitingCurve != none)
  {
    status.remedies.emplace_back(
      Remedy::ReleaseCurves, quotedNames(curves, { report.limitingCurve }));
  }
  status.remedies.emplace_back(Remedy::TakeSofterCloth);
  return status;
}

/// What the cloth of the options promised the last piece of a result and did not keep, the worst
/// first: MissingGrain, BeyondLimits
/// (ids: triangles, the one farthest out first).
std::vector<Status> brokenClothPromises(const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const FlatteningResult& result)
{
  std::vector<Status> broken;
  if (!options.cloth)
  {
    return broken;
  }
  const auto& report = result.pieces.back().cloth;
  if (report && report->grain.missing)
  {
    broken.push_back(missingGrain(curves, *options.cloth, report->grain));
  }
  if (report && report->threads.shareOutOfLimit > toleratedShareOutOfLimit)
  {
    broken.push_back(beyondLimits(curves, *options.cloth, result));
  }
  return broken;
}

/// Errors up to this are rounding of a solution that is none the worse for it.
constexpr double roundingError = 1e-6;

/// The wires of the last piece that miss their lengths.
class WrongLengths
{
public:
  WrongLengths(const CutSurface& cut, const std::vector<FeatureCurve>& curves, double tolerance,
    const FlatteningResult& result)
    : Cut(cut)
    , Curves(curves)
    , Result(result)
    , ErrorOfCurve(curves.size(), 0.0)
  {
    const auto piece = static_cast<Index>(result.pieces.size()) - 1;
    for (const Wire& wire : result.wires)
    {
      const bool elastic = wire.curve != none && curves[wire.curve].tolerance > 0.0;
      if (wire.piece == piece && !wire.connector && !elastic &&
        !(wire.maximumEdgeError <= tolerance))
      {
        this->add(wire);
      }
    }
  }

  Status status() const
  {
    Indices off;
    for (std::size_t c = 0; c < this->Curves.size(); ++c)
    {
      if (this->ErrorOfCurve[c] > 0.0)
      {
        off.push_back(static_cast<Index>(c));
      }
    }
    std::stable_sort(off.begin(), off.end(),
      [this](Index a, Index b) { return this->ErrorOfCurve[a] > this->ErrorOfCurve[b]; });
    Status status{ StatusCode::LengthError, this->describe(off), {}, {} };
    status.ids = off.empty() ? ElementIds(ElementKind::Edges, this->WorstEdge)
                             : ElementIds(ElementKind::Curves, off);
    if (this->Worst <= roundingError)
    {
      status.remedies.emplace_back(Remedy::AllowLengthError);
    }
    const PieceReport& piece = this->Result.pieces.back();
    if (piece.area.tube())
    {
      status.remedies.emplace_back(Remedy::SeamBetweenLoops);
    }
    if (piece.wired)
    {
      status.remedies.emplace_back(Remedy::ReleaseCurves,
        off.empty() ? "a feature curve"
                    : quotedNames(this->Curves, { off.begin(), off.begin() + this->namedOf(off) }));
    }
    else if (status.remedies.empty())
    {
      status.remedies.emplace_back(Remedy::AddDarts);
    }
    return status;
  }

private:
  static std::ptrdiff_t namedOf(const Indices& off)
  {
    constexpr std::size_t most = 5;
    return static_cast<std::ptrdiff_t>(std::min(off.size(), most));
  }

  void add(const Wire& wire)
  {
    const double error = wire.maximumEdgeError;
    double& known = wire.curve == none ? this->ErrorOfBoundary : this->ErrorOfCurve[wire.curve];
    known = std::max(known, error);
    if (!(error <= this->Worst))
    {
      this->Worst = error;
      this->WorstEdge = this->worstEdge(wire);
    }
  }

  /// Vertices of the surface before the cut.
  Indices worstEdge(const Wire& wire) const
  {
    const TriangleMesh& mesh = this->Cut.mesh;
    Indices ends;
    double worst = -1.0;
    for (std::size_t k = 0; k + 1 < wire.vertices.size(); ++k)
    {
      const Index a = wire.vertices[k];
      const Index b = wire.vertices[k + 1];
      const double rest = (mesh.point(b) - mesh.point(a)).norm();
      const double flat = (this->Result.positions[b] - this->Result.positions[a]).norm();
      if (!(std::abs(flat - rest) <= worst * rest))
      {
        worst = std::abs(flat - rest) / rest;
        ends = { this->Cut.originalVertex[a], this->Cut.originalVertex[b] };
      }
    }
    return ends;
  }

  std::string describe(const Indices& off) const
  {
    std::string text;
    for (std::ptrdiff_t k = 0; k < namedOf(off); ++k)
    {
      const Index c = off[static_cast<std::size_t>(k)];
      text += (k > 0 ? ", \"" : "\"") + this->Curves[c].name + "\" by up to " +
        shortNumber(this->ErrorOfCurve[c]);
    }
    const std::size_t more = off.size() - static_cast<std::size_t>(namedOf(off));
    text += more > 0 ? " and " + std::to_string(more) + " more curves" : "";
    if (this->ErrorOfBoundary > 0.0)
    {
      text += (text.empty() ? "the boundary by up to " : ", the boundary by up to ") +
        shortNumber(this->ErrorOfBoundary);
    }
    return "wires miss the lengths of their edges (as a fraction): " + text;
  }

  const CutSurface& Cut;
  const std::vector<FeatureCurve>& Curves;
  const FlatteningResult& Result;
  std::vector<double> ErrorOfCurve;
  double ErrorOfBoundary = 0.0;
  double Worst = 0.0;
  Indices WorstEdge;
};

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

/// The cuts with a bank vertex on an edge that crosses another one.
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
  std::sort(curves.begin(), curves.end());
  curves.erase(std::unique(curves.begin(), curves.end()), curves.end());
  return curves;
}

Status overlap(const CutSurface& cut, const std::vector<FeatureCurve>& curves, bool closeCuts,
  const PieceReport& report)
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
    message += ", where the banks of " + quotedNames(curves, cuts) + " cross";
  }
  Status status{ StatusCode::Overlap, message, { ElementKind::Cells, triangles }, {} };
  if (!cuts.empty() && !closeCuts)
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

/// A piece that is not at a minimum: what is wrong with it, and what fits it as a way out.
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

/// The worse status, which tells the other as well.
Status together(Status worse, const Status& other)
{
  if (!other.ok())
  {
    worse.message += "; " + other.message;
    // Of a broken cloth the other defect may be the cause.
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

void judgeLastPiece(const CutSurface& cut, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, FlatteningResult& result)
{
  PieceReport& report = result.pieces.back();
  if (report.status.code == StatusCode::NotConverged)
  {
    explain(options, report);
  }
  const QualitySummary& quality = report.quality;
  const bool promised = options.scheme != Scheme::LeastSquaresConformal;
  if (promised && !(quality.maximumEdgeLengthError <= options.lengthTolerance) &&
    severity(StatusCode::LengthError) > severity(report.status.code))
  {
    report.status =
      together(WrongLengths(cut, curves, options.lengthTolerance, result).status(), report.status);
  }
  else if (report.status.ok() && !quality.flipped.empty())
  {
    report.status = flippedTriangles(report, options);
  }
  else if (report.status.ok() && report.overlaps.count > 0)
  {
    report.status = overlap(cut, curves, options.closeCuts, report);
  }
  for (const Status& broken : brokenClothPromises(curves, options, result))
  {
    report.status = report.status.ok() ? broken : together(report.status, broken);
  }
}
}
