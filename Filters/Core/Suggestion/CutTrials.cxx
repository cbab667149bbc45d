// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutTrials.h"

#include "Cut/SurfaceCut.h"
#include "Flattening/PieceArrangement.h"
#include "Flattening/SurfaceFlattening.h"
#include "Imprint/CurveImprint.h"
#include "Quality/StrainMeasures.h"
#include "Sparse/LinearSolver.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace flattening
{
namespace
{
/// What a trial takes beside its steps, in steps.
constexpr double besideSteps = 5.0;
/// Of the most steps of a trial, what it may take from where the surface lies uncut: where that is
/// bad a new start is quicker.
constexpr double startShare = 0.4;
/// Tolerances of flattenings that are only compared: energies are known to five digits by then.
constexpr double enoughToCompare = 1e-3;
constexpr double lengthTolerance = 1e-4;
/// A triangle with two edges on a straight key has no area in the plane, and rounding says to which
/// side it turns. Its small stretch is below this.
constexpr double collapsed = 1e-6;

/// No triangle counts for more, so that one that has collapsed does not hide all others.
constexpr double maxStrain = 2.0;

double strainOf(const TriangleQuality& quality)
{
  if (!(quality.smallStretch > 0.0))
  {
    return maxStrain;
  }
  return std::min(maxStrain,
    std::max(std::abs(std::log(quality.smallStretch)), std::abs(std::log(quality.largeStretch))));
}

/// By piece, the integral of a measure of triangles. \param counted area of each triangle
template <typename Measure>
std::vector<double> integrals(
  const FlatteningResult& flat, const std::vector<double>& counted, const Measure& measure)
{
  std::vector<double> sums(flat.pieces.size(), 0.0);
  for (Index t = 0; t < flat.cut->mesh.triangleCount(); ++t)
  {
    sums[flat.cut->pieceOfTriangle[t]] += counted[t] * measure(flat.triangles[t]);
  }
  return sums;
}

/// The middle of the triangle that is strained most of those that count.
Point3 worstPlace(const FlatteningResult& flat, const std::vector<double>& counted)
{
  Index worst = 0;
  double most = -1.0;
  for (Index t = 0; t < flat.cut->mesh.triangleCount(); ++t)
  {
    const double strain = strainOf(flat.triangles[t]);
    if (strain > most && counted[t] > 0.0)
    {
      most = strain;
      worst = t;
    }
  }
  return flat.cut->mesh.centroid(worst);
}

/// Whether one of the curves from `first` on meets a key curve anywhere but at the boundary.
bool touchesKey(const ImprintedSurface& surface, std::size_t first)
{
  std::vector<char> onKey(surface.mesh.vertexCount(), 0);
  for (std::size_t c = 0; c < first; ++c)
  {
    for (Index v : surface.curves[c].vertices)
    {
      onKey[v] = surface.curves[c].type == CurveType::Key ? 1 : onKey[v];
    }
  }
  for (std::size_t c = first; c < surface.curves.size(); ++c)
  {
    const Indices& vertices = surface.curves[c].vertices;
    if (std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return onKey[v] != 0; }))
    {
      return true;
    }
  }
  return false;
}

/// By piece, where areas are other than on the surface.
std::vector<StrainMeasures> strainMeasures(
  const FlatteningResult& flat, const std::vector<double>& counted)
{
  std::vector<TriangleFrames> frames(flat.pieces.size());
  std::vector<std::vector<TriangleQuality>> qualities(flat.pieces.size());
  for (Index t = 0; t < flat.cut->mesh.triangleCount(); ++t)
  {
    const Index piece = flat.cut->pieceOfTriangle[t];
    frames[piece].emplace_back();
    frames[piece].back().area = counted[t];
    qualities[piece].push_back(flat.triangles[t]);
  }
  std::vector<StrainMeasures> measures;
  for (std::size_t p = 0; p < frames.size(); ++p)
  {
    measures.push_back(measureStrain(frames[p], qualities[p]));
  }
  return measures;
}

/// The points of the curves from `first` on.
std::vector<Points3> pathsOf(const ImprintedSurface& surface, std::size_t first)
{
  std::vector<Points3> paths;
  for (std::size_t c = first; c < surface.curves.size(); ++c)
  {
    paths.emplace_back();
    for (Index v : surface.curves[c].vertices)
    {
      paths.back().push_back(surface.mesh.point(v));
    }
  }
  return paths;
}

/// Two cuts may meet in a point, not run along each other; and none may run along the boundary.
bool crossesItself(const ImprintedSurface& surface, std::size_t first)
{
  std::vector<char> used(surface.mesh.halfedgeCount(), 0);
  for (std::size_t c = 0; c < surface.curves.size(); ++c)
  {
    const FeatureCurve& curve = surface.curves[c];
    for (std::size_t k = 1; k < curve.vertices.size() && curve.opens(); ++k)
    {
      Index h = surface.mesh.find(curve.vertices[k - 1], curve.vertices[k]);
      const Index back = surface.mesh.find(curve.vertices[k], curve.vertices[k - 1]);
      if (h == none || back == none || used[h])
      {
        if (c >= first)
        {
          return true;
        }
        continue;
      }
      used[h] = 1;
      used[back] = 1;
    }
  }
  return false;
}

/// Whether the darts among the curves from `first` on cut off more than there is without them, as
/// where two meet at their tips.
bool dartsDivide(const ImprintedSurface& surface, std::size_t first)
{
  std::vector<FeatureCurve> others = surface.curves;
  const auto dart = [](const FeatureCurve& curve) { return curve.type == CurveType::Dart; };
  others.erase(
    std::remove_if(others.begin() + static_cast<std::ptrdiff_t>(first), others.end(), dart),
    others.end());
  return others.size() < surface.curves.size() &&
    cutSurface(surface.mesh, surface.curves).pieceCount !=
    cutSurface(surface.mesh, others).pieceCount;
}
}

std::vector<FlatCorners> cornersOf(const FlatteningResult& flat)
{
  std::vector<FlatCorners> corners;
  for (const auto& [a, b, c] : flat.cut->mesh.triangles())
  {
    corners.push_back({ flat.positions[a], flat.positions[b], flat.positions[c] });
  }
  return corners;
}

std::vector<Polyline> withLines(std::vector<Polyline> lines, const std::vector<Polyline>& more)
{
  lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

FlatteningOptions roughly(FlatteningOptions options)
{
  options.isometric.tolerance = std::max(options.isometric.tolerance, enoughToCompare);
  options.isometric.lengthTolerance = lengthTolerance;
  options.dartLegs = DartLegs::Free; // others take twice the work
  return options;
}

double TrialOutcome::cutLength() const
{
  return std::accumulate(this->lengths.begin(), this->lengths.end(), 0.0);
}

CutTrials::CutTrials(const TriangleMesh& mesh, std::vector<Polyline> curves,
  const ImprintOptions& imprint, const FlatteningOptions& flattening, SearchGoal goal,
  RegionWeights weights, double maxSteps)
  : Mesh(mesh)
  , Curves(std::move(curves))
  , Imprint(imprint)
  , Flattening(flattening)
  , Goal(goal)
  , Weights(std::move(weights))
  , MostSteps(maxSteps)
{
  this->Imprint.split = true;
  this->Flattening.arrange = false;
  this->Flattening.tryReleases = false;
}

ImprintedSurface CutTrials::imprinted(const std::vector<Polyline>& cuts) const
{
  ImprintedSurface surface =
    imprintCurves(this->Mesh, withLines(this->Curves, cuts), this->Imprint);
  const std::size_t first = this->Curves.size();
  if (surface.status.ok() &&
    (touchesKey(surface, first) || crossesItself(surface, first) || dartsDivide(surface, first)))
  {
    surface.status.code = StatusCode::InvalidCurve;
  }
  return surface;
}

std::vector<Points3> CutTrials::paths(const std::vector<Polyline>& cuts) const
{
  const ImprintedSurface surface = this->imprinted(cuts);
  return surface.status.ok() ? pathsOf(surface, this->Curves.size()) : std::vector<Points3>{};
}

CutTrials::Trial CutTrials::tried(
  const std::vector<Polyline>& cuts, double most, const Execution& execution) const
{
  Trial trial;
  const auto triangles = static_cast<double>(this->Mesh.triangleCount());
  std::atomic<std::int64_t> factorized = 0; // in attempts that were given up as well
  double limit = most;
  Execution counting = execution.nestedExecution();
  counting.factorized = &factorized;
  counting.cancel = [&factorized, &execution, &limit] {
    return static_cast<double>(factorized) > limit || execution.cancelled();
  };
  trial.surface = this->imprinted(cuts);
  const bool starts = !this->Start.empty();
  for (bool fromStart : { true, false })
  {
    if (!trial.surface.status.ok() || fromStart > starts || trial.outcome.valid)
    {
      continue;
    }
    // Where the surface lies badly uncut a start from there may take longer than a new one.
    const double steps = cuts.empty() ? std::numeric_limits<double>::infinity()
      : fromStart                     ? startShare * this->MostSteps
                                      : this->MostSteps;
    limit = std::min(most, static_cast<double>(factorized) + factorizationWork(triangles) * steps);
    FlatteningOptions options = this->Flattening;
    options.start = fromStart ? this->startOf(trial.surface) : std::vector<FlatCorners>();
    trial.flat = flattenSurface(trial.surface.mesh, trial.surface.curves, options, counting);
    if (!trial.flat.status.refused())
    {
      trial.outcome = this->measured(trial.surface, trial.flat);
    }
  }
  trial.work = besideSteps * triangles + static_cast<double>(factorized);
  return trial;
}

CutTrials::Trial CutTrials::trial(
  const std::vector<Polyline>& cuts, TrialBudget& budget, const Execution& execution) const
{
  Trial trial = this->tried(cuts, budget.left(), execution);
  budget.pay(trial.work);
  return trial;
}

TrialOutcome CutTrials::startUncut(TrialBudget& budget, const Execution& execution)
{
  this->Start.clear();
  Trial trial = this->trial({}, budget, execution);
  const FlatteningResult& flat = trial.flat;
  const bool whole = !this->Flattening.preventOverlap && trial.outcome.valid &&
    trial.outcome.flipped == 0 && flat.leftOut.empty() &&
    trial.surface.mesh.triangles() == this->Mesh.triangles();
  this->Start = whole ? cornersOf(flat) : std::vector<FlatCorners>();
  return std::move(trial.outcome);
}

/// By triangle of the surface with cuts, its corners in the triangle that it is a part of.
std::vector<FlatCorners> CutTrials::startOf(const ImprintedSurface& surface) const
{
  std::vector<FlatCorners> start;
  for (Index t = 0; t < surface.mesh.triangleCount(); ++t)
  {
    const Index before = surface.originalTriangle[t];
    const Triangle& whole = this->Mesh.triangle(before);
    FlatCorners corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      const VertexSource& source = surface.vertexSource[surface.mesh.triangle(t)[k]];
      corners[k] = Point2::Zero();
      for (std::size_t i = 0; i < whole.size(); ++i)
      {
        const auto place = std::find(whole.begin(), whole.end(), source.vertices[i]);
        if (place != whole.end())
        {
          corners[k] += source.weights[i] * this->Start[before][place - whole.begin()];
        }
        else if (source.weights[i] != 0.0)
        {
          return {};
        }
      }
    }
    start.push_back(corners);
  }
  return start;
}

TrialOutcome CutTrials::measured(
  const ImprintedSurface& surface, const FlatteningResult& flat) const
{
  TrialOutcome outcome;
  outcome.valid = true;
  outcome.severity = severity(flat.status.code);
  for (const Points3& path : pathsOf(surface, this->Curves.size()))
  {
    outcome.lengths.push_back(polylineLength(path));
  }
  std::vector<double> counted; // by triangle, its area on the surface times its weight
  std::vector<double> areas(flat.pieces.size(), 0.0);
  std::vector<double> countedAreas(flat.pieces.size(), 0.0);
  for (Index t = 0; t < flat.cut->mesh.triangleCount(); ++t)
  {
    const double weight = this->Weights.empty()
      ? 1.0
      : this->Weights[surface.originalTriangle[flat.cut->originalTriangle(t)]];
    const double area = flat.cut->mesh.area(t);
    counted.push_back(weight * area);
    areas[flat.cut->pieceOfTriangle[t]] += area;
    countedAreas[flat.cut->pieceOfTriangle[t]] += counted.back();
  }
  outcome.worstPlace = worstPlace(flat, counted);
  const std::vector<StrainMeasures> strains =
    this->Weights.empty() ? std::vector<StrainMeasures>{} : strainMeasures(flat, counted);
  double total = 0.0;
  for (std::size_t p = 0; p < flat.pieces.size(); ++p)
  {
    const QualitySummary& quality = flat.pieces[p].quality;
    const StrainMeasures strain =
      strains.empty() ? StrainMeasures{ quality.strainP95, quality.rigidEnergy } : strains[p];
    outcome.energy += countedAreas[p] * strain.rigidEnergy;
    outcome.areaError += areas[p] * quality.areaError;
    total += areas[p];
    outcome.strainP95 = std::max(outcome.strainP95, strain.quantile);
    outcome.pieceStrains.push_back(strain.quantile);
    outcome.pieceGoals.push_back(countedAreas[p] * strain.rigidEnergy);
    outcome.pieceFaults.push_back(
      !quality.flipped.empty() || flat.pieces[p].overlaps.count > 0 ? 1 : 0);
    outcome.flipped += quality.flipped.size();
    outcome.overlaps += flat.pieces[p].overlaps.count;
  }
  std::vector<Points2> places(flat.pieces.size());
  for (Index h = 0; h < flat.cut->mesh.halfedgeCount(); ++h)
  {
    if (flat.cut->mesh.twin(h) == none)
    {
      places[flat.cut->pieceOfTriangle[h / 3]].push_back(flat.positions[flat.cut->mesh.from(h)]);
    }
  }
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    outcome.waste += std::max(0.0, hullArea(places[p]) - areas[p]);
  }
  outcome.flipped += static_cast<std::size_t>(std::count_if(
    flat.triangles.begin(), flat.triangles.end(), [](const TriangleQuality& triangle) {
      return triangle.smallStretch >= 0.0 && triangle.smallStretch < collapsed;
    }));
  outcome.areaError /= total;
  for (double area : areas)
  {
    outcome.pieceAreas.push_back(area / total);
    outcome.minPiece = std::min(outcome.minPiece, area / total);
  }
  if (this->Goal == SearchGoal::Strain)
  {
    outcome.pieceGoals = integrals(flat, counted,
      [](const TriangleQuality& triangle) { return std::pow(strainOf(triangle), 4.0); });
  }
  else if (this->Goal == SearchGoal::Area)
  {
    outcome.pieceGoals = integrals(flat, counted,
      [](const TriangleQuality& triangle) { return std::abs(triangle.areaRatio - 1.0); });
  }
  outcome.goal = std::accumulate(outcome.pieceGoals.begin(), outcome.pieceGoals.end(), 0.0);
  return outcome;
}

std::vector<TrialOutcome> CutTrials::runAll(const std::vector<std::vector<Polyline>>& cuts,
  TrialBudget& budget, const Execution& execution) const
{
  std::vector<TrialOutcome> outcomes(cuts.size());
  const Execution inner = execution.nestedExecution();
  const auto count = static_cast<Index>(cuts.size());
  for (Index first = 0; first < count && !budget.spent(); first += triedTogether)
  {
    const Index last = std::min(count, first + triedTogether);
    std::vector<double> work(last - first, 0.0);
    execution.forEachTask(last - first, [&](Index k) {
      if (!inner.cancelled() && !cuts[first + k].empty())
      {
        Trial trial = this->tried(cuts[first + k], budget.left(), inner);
        outcomes[first + k] = std::move(trial.outcome);
        work[k] = trial.work;
      }
    });
    for (double one : work)
    {
      if (one > 0.0)
      {
        budget.pay(one);
      }
    }
  }
  return outcomes;
}
}
