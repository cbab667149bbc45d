// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/BoundarySymmetry.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
constexpr Index samples = 512;
/// Of the Gaussian by which turning is smoothed, as a share of the boundary's length.
constexpr double smoothing = 0.015;
/// Correlation of the boundary and its image from which on they may be the same.
constexpr double alike = 0.9;
/// Axes that are considered, and how far they lie apart at least, as a share of all.
constexpr std::size_t mostAxes = 8;
constexpr Index axesApart = samples / 32;
constexpr int mostRefinements = 3;

/// The boundary of length 1.
struct TurningLoop
{
  std::vector<double> arcs;  ///< by vertex
  std::vector<double> turns; ///< by vertex, in radians, to the side of the surface
};

TurningLoop turningLoop(const TriangleMesh& mesh)
{
  std::vector<double> angles(mesh.vertexCount(), 0.0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    angles[mesh.from(h)] += mesh.angle(h);
  }
  TurningLoop loop;
  double length = 0.0;
  const Indices boundary = mesh.boundaryLoops().front();
  for (Index h : boundary)
  {
    loop.arcs.push_back(length);
    loop.turns.push_back(pi - angles[mesh.from(h)]);
    length += mesh.length(h);
  }
  for (double& arc : loop.arcs)
  {
    arc /= length;
  }
  return loop;
}

/// To [-1/2, 1/2].
double wrapped(double arc)
{
  return arc - std::round(arc);
}

std::vector<double> smoothed(const TurningLoop& loop)
{
  std::vector<double> turning(samples, 0.0);
  for (Index m = 0; m < samples; ++m)
  {
    for (std::size_t v = 0; v < loop.arcs.size(); ++v)
    {
      const double distance = wrapped(static_cast<double>(m) / samples - loop.arcs[v]) / smoothing;
      if (std::abs(distance) < 5.0)
      {
        turning[m] += loop.turns[v] * std::exp(-0.5 * distance * distance);
      }
    }
  }
  double mean = 0.0;
  for (double value : turning)
  {
    mean += value / samples;
  }
  for (double& value : turning)
  {
    value -= mean;
  }
  return turning;
}

/// By the sum of the arcs of a point and its image, in samples, the correlation of both sides.
std::vector<double> correlations(const std::vector<double>& turning)
{
  double own = 0.0;
  for (double value : turning)
  {
    own += value * value;
  }
  std::vector<double> result(samples, 0.0);
  for (Index sum = 0; sum < samples && own > 0.0; ++sum)
  {
    for (Index m = 0; m < samples; ++m)
    {
      result[sum] += turning[m] * turning[(sum - m + samples) % samples];
    }
    result[sum] /= own;
  }
  return result;
}

/// The sum of arcs nearby by which vertices are images of vertices, in the median.
double refined(const TurningLoop& loop, double sum)
{
  for (int step = 0; step < mostRefinements; ++step)
  {
    std::vector<double> misses;
    for (double arc : loop.arcs)
    {
      double image = sum - arc;
      image -= std::floor(image);
      const auto after = std::lower_bound(loop.arcs.begin(), loop.arcs.end(), image);
      const double next = after == loop.arcs.end() ? loop.arcs.front() : *after;
      const double last = after == loop.arcs.begin() ? loop.arcs.back() : *(after - 1);
      const double forward = wrapped(next - image);
      const double backward = wrapped(last - image);
      misses.push_back(std::abs(forward) < std::abs(backward) ? forward : backward);
    }
    const auto middle = misses.begin() + static_cast<std::ptrdiff_t>(misses.size() / 2);
    std::nth_element(misses.begin(), middle, misses.end());
    sum += *middle;
  }
  return sum;
}
}

std::vector<double> boundaryAxes(const TriangleMesh& mesh)
{
  const TurningLoop loop = turningLoop(mesh);
  const std::vector<double> alikeness = correlations(smoothed(loop));
  Indices order;
  for (Index sum = 0; sum < samples; ++sum)
  {
    if (alikeness[sum] >= alike)
    {
      order.push_back(sum);
    }
  }
  std::stable_sort(
    order.begin(), order.end(), [&](Index a, Index b) { return alikeness[a] > alikeness[b]; });
  Indices chosen;
  std::vector<double> turns;
  for (Index sum : order)
  {
    const bool near = std::any_of(chosen.begin(), chosen.end(), [&](Index other) {
      const Index between = std::abs(sum - other);
      return std::min(between, samples - between) < axesApart;
    });
    if (near || chosen.size() >= mostAxes)
    {
      continue;
    }
    chosen.push_back(sum);
    const double plain = static_cast<double>(sum) / samples;
    for (double place : { refined(loop, plain), plain })
    {
      turns.push_back(pi * (place - std::floor(place)));
    }
  }
  return turns;
}
}
