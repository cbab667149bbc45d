// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutTrials.h"

#include "Flattening/SurfaceFlattening.h"
#include "Imprint/CurveImprint.h"

#include <algorithm>

namespace flattening
{
namespace
{
bool isCut(const FeatureCurve& curve)
{
  return curve.type == CurveType::Dart || curve.type == CurveType::Seam;
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
    for (Index v : surface.curves[c].vertices)
    {
      if (onKey[v])
      {
        return true;
      }
    }
  }
  return false;
}

/// Two cuts may meet in a point, not run along each other; and none may run along the boundary.
bool crossesItself(const ImprintedSurface& surface, std::size_t first)
{
  std::vector<char> used(surface.mesh.halfedgeCount(), 0);
  for (std::size_t c = 0; c < surface.curves.size(); ++c)
  {
    const FeatureCurve& curve = surface.curves[c];
    for (std::size_t k = 1; k < curve.vertices.size() && isCut(curve); ++k)
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
}

double TrialOutcome::cutLength() const
{
  double sum = 0.0;
  for (double length : this->lengths)
  {
    sum += length;
  }
  return sum;
}

CutTrials::CutTrials(const TriangleMesh& mesh, std::vector<Polyline> curves,
  const ImprintOptions& imprint, const FlatteningOptions& flattening)
  : Mesh(mesh)
  , Curves(std::move(curves))
  , Imprint(imprint)
  , Flattening(flattening)
{
  this->Imprint.split = true;
  this->Flattening.arrange = false;
  this->Flattening.tryReleases = false;
}

TrialOutcome CutTrials::run(const std::vector<Polyline>& cuts, const Execution& execution) const
{
  TrialOutcome outcome;
  std::vector<Polyline> polylines = this->Curves;
  polylines.insert(polylines.end(), cuts.begin(), cuts.end());
  const ImprintedSurface surface = imprintCurves(this->Mesh, polylines, this->Imprint);
  const std::size_t first = this->Curves.size();
  if (!surface.status.ok() || touchesKey(surface, first) || crossesItself(surface, first))
  {
    return outcome;
  }
  for (std::size_t c = first; c < surface.curves.size(); ++c)
  {
    Points3 path;
    double length = 0.0;
    for (Index v : surface.curves[c].vertices)
    {
      length += path.empty() ? 0.0 : (surface.mesh.point(v) - path.back()).norm();
      path.push_back(surface.mesh.point(v));
    }
    outcome.paths.push_back(std::move(path));
    outcome.lengths.push_back(length);
  }
  const FlatteningResult flat =
    flattenSurface(surface.mesh, surface.curves, this->Flattening, execution);
  if (flat.status.refused())
  {
    return outcome;
  }
  outcome.valid = true;
  outcome.severity = severity(flat.status.code);
  std::vector<double> areas(flat.pieces.size(), 0.0);
  for (Index t = 0; t < flat.cut->mesh.triangleCount(); ++t)
  {
    areas[flat.cut->pieceOfTriangle[t]] += flat.cut->mesh.area(t);
  }
  double total = 0.0;
  for (std::size_t p = 0; p < flat.pieces.size(); ++p)
  {
    const QualitySummary& quality = flat.pieces[p].quality;
    outcome.energy += areas[p] * quality.rigidEnergy;
    outcome.areaError += areas[p] * quality.areaError;
    total += areas[p];
    outcome.strainP95 = std::max(outcome.strainP95, quality.strainP95);
    outcome.pieceStrains.push_back(quality.strainP95);
    outcome.pieceEnergies.push_back(areas[p] * quality.rigidEnergy);
    outcome.flipped += quality.flipped.size();
    outcome.overlaps += flat.pieces[p].overlaps.count;
  }
  outcome.areaError /= total;
  return outcome;
}

std::vector<TrialOutcome> CutTrials::runAll(
  const std::vector<std::vector<Polyline>>& cuts, const Execution& execution) const
{
  std::vector<TrialOutcome> outcomes(cuts.size());
  execution.parallelFor(static_cast<Index>(cuts.size()), [&](Index begin, Index end) {
    for (Index k = begin; k < end; ++k)
    {
      if (!cuts[k].empty())
      {
        outcomes[k] = this->run(cuts[k], {});
      }
    }
  });
  return outcomes;
}
}
