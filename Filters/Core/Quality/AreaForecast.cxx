// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/AreaForecast.h"

#include "Quality/ScaleFactor.h"
#include "Quality/SurfaceDevelopability.h"
#include "Surface/EdgePaths.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{
/// A cone whose tip lacks this angle loses a quarter of its area, k / (2 pi + k); curvature that is
/// spread out loses less. In radians.
constexpr double harmless = 2.0;

/// Sum of the positive angle defects, 2 pi less the angles around inner vertices.
double risingCurvature(const TriangleMesh& mesh, const Execution& execution)
{
  double total = 0.0;
  for (double defect : angleDefects(mesh, cornerAngles(mesh, execution)))
  {
    total += std::max(0.0, defect);
  }
  return total;
}

/// The part of the area that is lost.
double lossBy(const TriangleMesh& mesh, const std::vector<double>& u)
{
  double area = 0.0;
  double flat = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangle(t);
    area += mesh.area(t);
    for (Index v : c)
    {
      flat += mesh.area(t) / 3.0 * std::exp(-2.0 * u[v]);
    }
  }
  return 1.0 - flat / area;
}

/// See AreaForecast::openings.
std::vector<Indices> cutsOfTube(const TriangleMesh& mesh)
{
  const std::vector<Indices> loops = mesh.boundaryLoops();
  std::vector<Indices> ends;
  for (const Indices& loop : loops)
  {
    const double lost = 1.0 + turnOf(mesh, loop) / (2.0 * pi);
    if (ends.empty() || lost >= AreaForecast::noticeable)
    {
      ends.push_back(loop);
    }
  }
  return ends.size() > 1 ? joiningPaths(mesh, std::move(ends)) : std::vector<Indices>();
}

ScaleFactorOptions withoutSites(Indices fixed)
{
  ScaleFactorOptions options;
  options.fixed = std::move(fixed);
  options.mostSites = 1;
  return options;
}
}

AreaForecast forecastArea(const TriangleMesh& mesh, const Execution& execution)
{
  AreaForecast forecast;
  forecast.openings = cutsOfTube(mesh);
  if (risingCurvature(mesh, execution) < harmless)
  {
    forecast.known = true;
    return forecast;
  }
  const ScaleFactor before(mesh, withoutSites({}), execution);
  if (!before.ok())
  {
    return forecast;
  }
  forecast.known = true;
  const std::vector<double>& u = before.values();
  const double loss = lossBy(mesh, u);
  if (!(loss >= AreaForecast::noticeable))
  {
    return forecast;
  }
  forecast.loss = loss;
  forecast.lossAfterCut = loss;
  Indices boundary;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (mesh.outgoing(v) != none && mesh.onBoundary(v))
    {
      boundary.push_back(v);
    }
  }
  const auto deepest = static_cast<Index>(std::max_element(u.begin(), u.end()) - u.begin());
  const EdgePaths paths(mesh, boundary);
  if (!paths.reaches(deepest) || mesh.onBoundary(deepest))
  {
    return forecast;
  }
  forecast.cut = paths.path(deepest);
  const ScaleFactor after(mesh, withoutSites(forecast.cut), execution);
  if (after.ok())
  {
    forecast.lossAfterCut = lossBy(mesh, after.values());
  }
  return forecast;
}
}
