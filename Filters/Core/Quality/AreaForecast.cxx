// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/AreaForecast.h"

#include "Quality/ScaleFactor.h"
#include "Surface/EdgePaths.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
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
double risingCurvature(const TriangleMesh& mesh)
{
  // The angles at a vertex add up as the arguments of complex numbers do in their product, which
  // takes one arctangent a vertex in the place of one a corner.
  std::vector<std::complex<double>> product(mesh.vertexCount(), 1.0);
  std::vector<Index> halfTurns(mesh.vertexCount(), 0);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangle(t);
    const std::array<Point3, 3> side{ mesh.points()[c[1]] - mesh.points()[c[0]],
      mesh.points()[c[2]] - mesh.points()[c[1]], mesh.points()[c[0]] - mesh.points()[c[2]] };
    const double sine = side[0].cross(side[1]).norm();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double cosine = -side[k].dot(side[(k + 2) % 3]);
      std::complex<double>& sum = product[c[k]];
      // Taken up to a whole turn, the sum passes pi where the sign of the imaginary part falls, and
      // 2 pi where it rises again.
      const bool upper = sum.imag() >= 0.0;
      const double re = sum.real() * cosine - sum.imag() * sine;
      const double im = sum.real() * sine + sum.imag() * cosine;
      const double scale = 1.0 / std::max(std::abs(re), std::abs(im));
      sum = { re * scale, im * scale };
      halfTurns[c[k]] += upper != (im >= 0.0) ? 1 : 0;
    }
  }
  double total = 0.0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (mesh.outgoing(v) != none && !mesh.onBoundary(v))
    {
      const std::complex<double>& z = product[v];
      const double rest = std::atan2(std::abs(z.imag()), z.imag() >= 0.0 ? z.real() : -z.real());
      total += std::max(0.0, 2.0 * pi - pi * halfTurns[v] - rest);
    }
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
  options.maxSites = 0;
  return options;
}
}

AreaForecast forecastArea(const TriangleMesh& mesh, const Execution& execution)
{
  AreaForecast forecast;
  forecast.openings = cutsOfTube(mesh);
  if (risingCurvature(mesh) < harmless)
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
