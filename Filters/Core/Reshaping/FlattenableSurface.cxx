// SPDX-License-Identifier: BSD-3-Clause
#include "Reshaping/FlattenableSurface.h"

#include "Base/Execution.h"
#include "Base/Memory.h"
#include "Base/Types.h"
#include "Flattening/FlatteningResult.h"
#include "Flattening/SurfaceFlattening.h"
#include "Quality/StrainMeasures.h"
#include "Sewing/BodyContact.h"
#include "Sewing/SewingModel.h"
#include "Surface/TriangleMesh.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace flattening
{
namespace
{
/// The surface is flattened again before rest would matter, and where it finds none.
constexpr double energyTolerance = 1e-4;
constexpr int maximumRestIterations = 60;

/// A surface while it is changed, over the triangles of its design.
class ReshapedSurface
{
public:
  /// \param design it must outlive the surface. \param held per vertex: it stays where it is.
  ReshapedSurface(const TriangleMesh& design, std::vector<char> held)
    : Design(&design)
    , Held(std::move(held))
    , Outwards(vertexNormals(design))
    , Points(design.points())
  {
  }

  const Points3& points() const { return this->Points; }

  TriangleMesh mesh() const
  {
    return { this->Points, this->Design->triangles(), this->Design->twins() };
  }

  bool canMove() const
  {
    return std::find(this->Held.begin(), this->Held.end(), 0) != this->Held.end();
  }

  /// Sews flat pieces of the surface together again and lets them come to rest between themselves
  /// and the design; the surface then lies where the cloth does. Shapes that found no rest end
  /// where they are. \param relative thickness and gap over the root of the area. \return false
  /// where the run is cancelled; the surface is as before then.
  bool sew(
    const FlatteningResult& flat, const ClothProperties& relative, const Execution& execution)
  {
    SewnTopology topology = sewnShapes(*flat.cut, flat.positions, SewingTest::Product);
    Points3 sewn = this->Points;
    for (SewnShape& shape : topology.shapes)
    {
      const double area = shape.cloth.restArea();
      if (!(area > 0.0))
      {
        continue;
      }
      Indices original;
      Points3 from;
      for (std::size_t v = 0; v < shape.vertices.size(); ++v)
      {
        original.push_back(flat.cut->originalVertex[shape.vertices[v]]);
        shape.cloth.points[v] = this->Design->point(original[v]);
        shape.cloth.held[v] = this->Held[original[v]];
        shape.cloth.outwards.push_back(this->Outwards[original[v]]);
        from.push_back(this->Points[original[v]]);
      }
      ClothProperties properties = relative;
      properties.thickness *= std::sqrt(area);
      properties.gap *= std::sqrt(area);
      SewingModel model(shape.cloth, properties);
      if (model.unknownCount() == 0)
      {
        continue;
      }
      RestOptions rest;
      rest.energyTolerance = energyTolerance;
      rest.maximumIterations = maximumRestIterations;
      const NewtonKktState end = bringToRest(model, from, rest, execution);
      if (end.cancelled())
      {
        return false;
      }
      const Points3 points = model.positions(end.x);
      for (std::size_t v = 0; v < points.size(); ++v)
      {
        if (!shape.cloth.held[v] && isFinite(points[v]))
        {
          sewn[original[v]] = this->settled(original[v], points[v], relative.outsideBias);
        }
      }
    }
    this->Points = std::move(sewn);
    return true;
  }

  /// The surface by so much of the way from the design, 0 to 1.
  ReshapedSurface partOfTheWay(double share) const
  {
    ReshapedSurface part = *this;
    for (Index v = 0; v < this->Design->vertexCount(); ++v)
    {
      const Point3& designed = this->Design->point(v);
      part.Points[v] =
        this->Held[v] ? designed : Point3(designed + share * (this->Points[v] - designed));
    }
    return part;
  }

private:
  /// Where a vertex ends that cloth takes there: with a full bias not inwards of its place.
  Point3 settled(Index vertex, const Point3& place, double outsideBias) const
  {
    const Point3& out = this->Outwards[vertex];
    const double along = out.dot(place - this->Design->point(vertex));
    // Springs give, if by little.
    return outsideBias >= 1.0 && along < 0.0 ? Point3(place - along * out) : place;
  }

  const TriangleMesh* Design; // of which surfaces are copied
  std::vector<char> Held;
  Points3 Outwards; // of the design
  Points3 Points;
};

SurfaceShift measureShift(const TriangleMesh& design, const Points3& points)
{
  SurfaceShift shift;
  const std::vector<double> areas =
    vertexAreas(design.triangles(), points.size(), [&design](Index t) { return design.area(t); });
  const double area = design.area();
  std::vector<AreaValue> values;
  const Points3 outwards = vertexNormals(design);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    const Point3 moved = points[v] - design.point(static_cast<Index>(v));
    shift.ofVertex.push_back(moved.norm());
    shift.outwardsOfVertex.push_back(outwards[v].dot(moved));
    shift.outwardsMean += areas[v] / area * shift.outwardsOfVertex[v];
    shift.inwardsMax = std::max(shift.inwardsMax, -shift.outwardsOfVertex[v]);
    shift.mean += areas[v] / area * shift.ofVertex[v];
    shift.max = std::max(shift.max, shift.ofVertex[v]);
    values.push_back({ shift.ofVertex[v], areas[v] });
  }
  shift.size = std::sqrt(area);
  shift.p95 = areaQuantile(std::move(values));
  return shift;
}

/// Springs from those that let a surface move by about a tenth of what strain asks for, down to
/// those that hold it but against drifting.
constexpr double firstAnchor = 64.0;
constexpr double lastAnchor = 1e-3;
constexpr double weakening = 4.0;
/// Flattenings and sewings in turn before springs are weakened.
constexpr int roundsPerAnchor = 3;
/// Strengthenings between springs that are too strong and springs that will do.
constexpr int anchorHalvings = 3;
constexpr int wayHalvings = 6;
/// Under the weakest springs rounds go on for as long as this many of them lower the strain by that
/// fraction: each takes out a part of what is left, as of a diffusion.
constexpr std::size_t roundsToGain = 4;
constexpr double minGain = 0.03;
/// Where they do not, the surface lies in wrinkles a few triangles wide. As a plate thicker by
/// these factors, then thinner by halves, it lies smoothly, and rounds go on from there.
constexpr std::array<double, 5> thickenings{ 1.0, 8.0, 32.0, 64.0, 16.0 };
/// Flattenings of a search, whatever they gain.
constexpr std::size_t maximumTrials = 400;
/// Of the search; the rest is the flattenings before and after.
constexpr double searchShare = 0.9;
/// Over the root of the area: what is kept from a body, and what rounding leaves of it.
constexpr double gapToBody = 1e-3;
constexpr double rounding = 1e-9; ///< of places beside a body or on the side of a bias

Status checked(const std::vector<FeatureCurve>& curves, const FlattenableOptions& options)
{
  if (!std::isfinite(options.bound) || options.bound <= 0.0 || options.bound >= 1.0)
  {
    return invalidOption("the bound on strain is outside (0, 1)", "0.02 for 2 %");
  }
  if (!std::isfinite(options.thickness) || options.thickness < 0.0 || options.thickness > 1.0)
  {
    return invalidOption("the thickness is outside 0..1", "a fraction of the size of a piece");
  }
  if (!std::isfinite(options.outsideBias) || options.outsideBias < 0.0 || options.outsideBias > 1.0)
  {
    return invalidOption("the outside bias is outside 0..1", "0 for none, 1 for outwards alone");
  }
  for (Index curve : options.kept)
  {
    if (curve < 0 || curve >= static_cast<Index>(curves.size()))
    {
      return invalidOption("a curve to keep is not there", "the number of a curve");
    }
  }
  return {};
}

/// Vertices that stay: of the boundary, of kept curves, and of pieces that are left out.
std::vector<char> heldVertices(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlattenableOptions& options, const FlatteningResult& flat)
{
  std::vector<char> held(mesh.vertexCount(), 0);
  for (Index v = 0; options.keepBoundary && v < mesh.vertexCount(); ++v)
  {
    held[v] = mesh.outgoing(v) != none && mesh.onBoundary(v) ? 1 : 0;
  }
  for (Index curve : options.kept)
  {
    for (Index v : curves[curve].vertices)
    {
      held[v] = 1;
    }
  }
  std::vector<char> flattened(mesh.triangleCount(), 0);
  for (Index t = 0; t < flat.cut->mesh.triangleCount(); ++t)
  {
    flattened[flat.cut->originalTriangle(t)] = 1;
  }
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int k = 0; k < 3 && !flattened[t]; ++k)
    {
      held[mesh.triangle(t)[k]] = 1;
    }
  }
  return held;
}

/// What of the area of the surface was not free to move, in words; empty: nothing.
std::string describeLimits(
  const TriangleMesh& design, const FlattenableSurface& result, const FlattenableOptions& options)
{
  double kept = 0.0;
  double againstBias = 0.0;
  double all = 0.0;
  for (Index t = 0; t < design.triangleCount(); ++t)
  {
    const double third = design.area(t) / 3.0;
    for (Index v : design.triangle(t))
    {
      all += third;
      kept += result.kept[v] ? third : 0.0;
      againstBias += !result.kept[v] && options.outsideBias >= 1.0 &&
          result.shift.outwardsOfVertex[v] <= rounding * result.shift.size
        ? third
        : 0.0;
    }
  }
  std::string words;
  const auto add = [&words, all](double area, const std::string& what) {
    words += area > 0.0 ? (words.empty() ? "" : ", ") + percent(area / all) + what : "";
  };
  add(kept, " of the area is kept where it is");
  add(againstBias, " of it lies where it may move outwards only");
  if (options.body)
  {
    words += (words.empty() ? "" : ", ") + std::string("the body is not entered");
  }
  return words;
}

double strainOf(const FlatteningResult& flat)
{
  double strain = flat.status.refused() ? std::numeric_limits<double>::infinity() : 0.0;
  for (const PieceReport& piece : flat.pieces)
  {
    strain = std::max(strain, piece.quality.strainP95);
  }
  return strain;
}

/// Whether no vertex that may move lies in a body, or deeper in it than the design.
class OutsideOfBody
{
public:
  OutsideOfBody(const TriangleMesh* body, const TriangleMesh& design, const std::vector<char>& held)
    : Held(held)
  {
    if (body)
    {
      this->Body = std::make_unique<ContactBody>(*body);
      this->Slack = rounding * measureShift(design, design.points()).size;
      for (const Point3& p : design.points())
      {
        this->Designed.push_back(std::min(0.0, this->Body->locate(p).distance));
      }
    }
  }
  bool outside(const Points3& points) const
  {
    for (std::size_t v = 0; this->Body && v < points.size(); ++v)
    {
      if (!this->Held[v] &&
        this->Body->locate(points[v]).distance < this->Designed[v] - this->Slack)
      {
        return false;
      }
    }
    return true;
  }

private:
  const std::vector<char>& Held;
  std::unique_ptr<ContactBody> Body;
  double Slack = 0.0;
  std::vector<double> Designed;
};

class Search
{
public:
  Search(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
    const FlattenableOptions& options, const std::vector<char>& held, const Execution& execution,
    FlattenableSurface& result)
    : Design(mesh)
    , Curves(curves)
    , Options(options)
    , Run(execution)
    , Silent(execution)
    , Result(result)
    , Quick(options.flattening)
    , Body(options.body, mesh, held)
    , Surface(mesh, held)
    , Best(Surface)
    , BestStrain(result.strainBefore)
  {
    this->Silent.progress = nullptr;
    this->Quick.tryReleases = false;
    this->Quick.arrange = false;
  }

  const ReshapedSurface& best() const { return this->Best; }

  /// \return false where it was cancelled
  bool run()
  {
    this->Result.trials.push_back({ 0.0, 0.0, this->BestStrain, 0.0 });
    if (this->met())
    {
      return true;
    }
    if (!this->Surface.canMove())
    {
      this->Result.hindrance = "every vertex is kept where it is";
      return true;
    }
    double weak = firstAnchor;
    double strong = 0.0; // springs that were too strong
    ReshapedSurface before = this->Surface;
    this->Flat = this->Result.before;
    while (!this->relax(weak) && this->goesOn() && weak > weakening * lastAnchor)
    {
      strong = weak;
      before = this->Surface;
      weak /= weakening;
      this->reportProgress(weak);
    }
    if (!this->met())
    {
      strong = 0.0;
      this->relaxLong(weak);
    }
    for (int k = 0; k < anchorHalvings && strong > 0.0 && this->met() && this->goesOn(); ++k)
    {
      const double middle = std::sqrt(strong * weak);
      this->Surface = before;
      this->flatten(middle, 1.0);
      if (this->relax(middle))
      {
        weak = middle;
      }
      else
      {
        strong = middle;
        before = this->Surface;
      }
    }
    if (this->met())
    {
      this->goBack(weak);
    }
    else if (this->Flat.status.refused())
    {
      this->Result.hindrance =
        "the moved surface could not be flattened (" + this->Flat.status.message + ")";
    }
    else
    {
      this->Result.hindrance = this->Result.trials.size() < maximumTrials
        ? "further moves hardly lower the strain"
        : "the search ended after " + std::to_string(maximumTrials) + " flattenings";
    }
    return !this->Cancelled;
  }

private:
  bool goesOn() const
  {
    return !this->Cancelled && !this->Flat.status.refused() &&
      this->Result.trials.size() < maximumTrials;
  }
  bool met() const { return this->BestStrain <= this->Options.bound; }

  /// Flattens the surface as it is, and keeps it where it is the best.
  double flatten(double anchor, double share)
  {
    const bool outside = this->Body.outside(this->Surface.points());
    this->Flat = flattenSurface(this->Surface.mesh(), this->Curves, this->Quick, this->Silent);
    this->Cancelled = this->Cancelled || this->Flat.status.code == StatusCode::Cancelled;
    const SurfaceShift shift = measureShift(this->Design, this->Surface.points());
    const FlattenableTrial trial{ anchor, share, strainOf(this->Flat), shift.mean / shift.size };
    this->Result.trials.push_back(trial);
    const bool better = outside && this->met()
      ? trial.strain <= this->Options.bound && trial.shift < this->BestShift
      : outside && trial.strain < this->BestStrain;
    if (better)
    {
      this->Best = this->Surface;
      this->BestStrain = trial.strain;
      this->BestShift = trial.shift;
    }
    return outside ? trial.strain : std::numeric_limits<double>::infinity();
  }

  /// Sews and flattens in turn. \return whether the bound holds
  bool relax(double anchor, double thickening = 1.0)
  {
    for (int round = 0; round < roundsPerAnchor && this->goesOn(); ++round)
    {
      ClothProperties properties;
      properties.anchor = anchor;
      properties.outsideBias = this->Options.outsideBias;
      properties.thickness = thickening * this->Options.thickness;
      properties.body = this->Options.body;
      properties.gap = gapToBody;
      if (!this->Surface.sew(this->Flat, properties, this->Silent))
      {
        this->Cancelled = true;
      }
      else if (this->flatten(anchor, 1.0) <= this->Options.bound)
      {
        return true;
      }
    }
    return false;
  }

  /// For as long as it lowers the strain, from where the surface is and from smoother ones.
  void relaxLong(double anchor)
  {
    for (double thickening : thickenings)
    {
      for (; thickening > 1.0 && !this->met() && this->goesOn(); thickening *= 0.5)
      {
        this->relax(anchor, thickening);
      }
      std::vector<double> strains{ this->BestStrain };
      const auto gains = [&strains] {
        return strains.size() <= roundsToGain ||
          strains.back() < (1.0 - minGain) * *(strains.end() - 1 - roundsToGain);
      };
      while (!this->met() && this->goesOn() && gains())
      {
        this->relax(anchor);
        strains.push_back(this->BestStrain);
      }
    }
  }

  /// From the best surface straight towards the design.
  void goBack(double anchor)
  {
    const ReshapedSurface whole = this->Best;
    double near = 0.0;
    double far = 1.0;
    for (int k = 0; k < wayHalvings && !this->Cancelled; ++k)
    {
      const double middle = 0.5 * (near + far);
      this->Surface = whole.partOfTheWay(middle);
      (this->flatten(anchor, middle) <= this->Options.bound ? far : near) = middle;
    }
  }

  void reportProgress(double anchor) const
  {
    this->Run.report(
      searchShare * std::log(firstAnchor / anchor) / std::log(firstAnchor / lastAnchor),
      "Moving the surface");
  }

  const TriangleMesh& Design;
  const std::vector<FeatureCurve>& Curves;
  const FlattenableOptions& Options;
  Execution Run;
  Execution Silent; ///< progress is that of the search
  FlattenableSurface& Result;
  FlatteningOptions Quick;
  OutsideOfBody Body;
  ReshapedSurface Surface;
  FlatteningResult Flat; ///< of the surface
  ReshapedSurface Best;
  double BestStrain;
  double BestShift = 0.0;
  bool Cancelled = false;
};

FlattenableSurface made(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlattenableOptions& options, const Execution& execution)
{
  const auto ended = [](const Status& status) {
    FlattenableSurface none;
    none.status = status;
    return none;
  };
  FlattenableSurface result;
  result.status = checked(curves, options);
  if (!result.status.ok())
  {
    return result;
  }
  const double part = 0.5 * (1.0 - searchShare);
  result.before = flattenSurface(mesh, curves, options.flattening, execution.part(0.0, part));
  if (result.before.status.refused())
  {
    return ended(result.before.status);
  }
  result.strainBefore = strainOf(result.before);
  result.kept = heldVertices(mesh, curves, options, result.before);
  Search search(mesh, curves, options, result.kept, execution.part(part, 1.0 - part), result);
  if (!search.run())
  {
    return ended({ StatusCode::Cancelled, "cancelled while moving the surface", {} });
  }
  result.mesh = search.best().mesh();
  result.shift = measureShift(mesh, result.mesh.points());
  result.after = result.shift.max > 0.0
    ? flattenSurface(result.mesh, curves, options.flattening, execution.part(1.0 - part, 1.0))
    : result.before;
  if (result.after.status.refused())
  {
    return ended(result.after.status);
  }
  result.status = result.after.status;
  result.strainAfter = strainOf(result.after);
  result.boundMet = result.strainAfter <= options.bound;
  if (!result.boundMet)
  {
    const std::string limits = describeLimits(mesh, result, options);
    if (result.hindrance.empty())
    {
      result.hindrance = "the flattening afterwards strains it more than the search found";
    }
    result.hindrance += (limits.empty() ? "" : ": ") + limits;
  }
  return result;
}
}

FlattenableSurface makeFlattenable(const TriangleMesh& mesh,
  const std::vector<FeatureCurve>& curves, const FlattenableOptions& options,
  const Execution& execution)
{
  return withinMemory([&] { return made(mesh, curves, options, execution); });
}
}
