// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SurfaceMirror.h"

#include "Cut/PieceTopology.h"
#include "Embedding/ConvexEmbedding.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{
/// The boundary's turning is correlated with its image at this many places.
constexpr Index samples = 512;
/// Of the Gaussian by which turning is smoothed, as a share of the boundary's length: some samples.
constexpr double smoothing = 0.015;
/// Correlation of the boundary and its image from which on they may be the same.
constexpr double minLikeness = 0.9;
/// Axes that are considered, and how far they lie apart at least: a square has four.
constexpr std::size_t maxAxes = 8;
constexpr Index axesApart = samples / 32;
/// Medians of the misses, which settle in two where vertices are images of each other.
constexpr int maxRefinements = 3;

/// The boundary of length 1.
struct TurningLoop
{
  std::vector<double> arcs;  ///< by vertex
  std::vector<double> turns; ///< by vertex, in radians, to the side of the surface
};

TurningLoop turningLoop(const TriangleMesh& mesh)
{
  TurningLoop loop;
  double length = 0.0;
  const Indices boundary = mesh.boundaryLoops().front();
  for (Index h : boundary)
  {
    loop.arcs.push_back(length);
    loop.turns.push_back(pi - angleSum(mesh, mesh.from(h)));
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
  const double own = std::inner_product(turning.begin(), turning.end(), turning.begin(), 0.0);
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
  for (int step = 0; step < maxRefinements; ++step)
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

/// Axes across which the boundary of a disk, laid on a circle by lengths with its first vertex at
/// angle 0, may be its own mirror image: its turning along its length, smoothed, is the same the
/// other way round. As angles of the axes on that circle, in [0, pi), the likeliest first; an axis
/// between vertices that are images of each other is exact. Empty where the boundary has no such
/// axis.
std::vector<double> boundaryAxes(const TriangleMesh& mesh)
{
  const TurningLoop loop = turningLoop(mesh);
  const std::vector<double> alikeness = correlations(smoothed(loop));
  Indices order;
  for (Index sum = 0; sum < samples; ++sum)
  {
    if (alikeness[sum] >= minLikeness)
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
    if (near || chosen.size() >= maxAxes)
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

/// No triangle counts for more, so that one that has collapsed does not hide all others.
constexpr double maxScale = 1.0;
/// Axes are compared by about this many triangles, and the best then measured by all.
constexpr Index triangleSamples = 150;

Points3 inSpace(const Points2& flat)
{
  Points3 points;
  for (const Point2& p : flat)
  {
    points.emplace_back(p.x(), p.y(), 0.0);
  }
  return points;
}

Point3 meanOf(const TriangleMesh& mesh, const ClosestPoint& place)
{
  Point3 mean = Point3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
  {
    mean += place.weights[k] * mesh.point(mesh.triangle(place.triangle)[k]);
  }
  return mean;
}
}

IntrinsicMirror::IntrinsicMirror(const TriangleMesh& mesh, const Points2& flat, double turn)
  : Mesh(mesh)
  , Flat(inSpace(flat), mesh.triangles())
  , Locator(this->Mesh)
  , FlatLocator(this->Flat)
  , Along(std::cos(turn), std::sin(turn))
  , Across(-std::sin(turn), std::cos(turn))
{
  double radius = 0.0;
  for (const Point2& p : flat)
  {
    radius = std::max(radius, p.norm());
  }
  this->Axis = { this->onSurface(radius * this->Along), this->onSurface(-radius * this->Along) };
}

std::shared_ptr<const IntrinsicMirror> IntrinsicMirror::find(
  const TriangleMesh& mesh, const Execution& execution, double tolerance)
{
  if (mesh.boundaryLoops().size() != 1 || eulerCharacteristic(mesh) != 1)
  {
    return nullptr;
  }
  const std::vector<double> turns = boundaryAxes(mesh);
  const Points2 flat = turns.empty() ? Points2() : embedConvexly(mesh, execution);
  if (flat.empty())
  {
    return nullptr;
  }
  std::shared_ptr<IntrinsicMirror> best;
  for (double turn : turns)
  {
    std::shared_ptr<IntrinsicMirror> mirror(new IntrinsicMirror(mesh, flat, turn));
    mirror->Error = mirror->meanStrain(std::max<Index>(1, mesh.triangleCount() / triangleSamples));
    if (!best || mirror->Error < best->Error)
    {
      best = std::move(mirror);
    }
  }
  best->Error = best->Error < tolerance ? best->meanStrain(1) : best->Error;
  return best->Error < tolerance ? best : nullptr;
}

Point2 IntrinsicMirror::onCircle(const Point3& point) const
{
  return meanOf(this->Flat, this->Locator.closest(point)).head<2>();
}

Point3 IntrinsicMirror::onSurface(const Point2& point) const
{
  return meanOf(this->Mesh, this->FlatLocator.closest({ point.x(), point.y(), 0.0 }));
}

Point3 IntrinsicMirror::mirrored(const Point3& point) const
{
  const Point2 p = this->onCircle(point);
  return this->onSurface(p - 2.0 * this->Across.dot(p) * this->Across);
}

Point3 IntrinsicMirror::projected(const Point3& point) const
{
  return this->onSurface(this->Along.dot(this->onCircle(point)) * this->Along);
}

double IntrinsicMirror::side(const Point3& point) const
{
  return this->Across.dot(this->onCircle(point));
}

double IntrinsicMirror::strainOf(Index triangle) const
{
  const Triangle& t = this->Mesh.triangle(triangle);
  const Point3 a = this->mirrored(this->Mesh.point(t[0]));
  const Point3 ab = this->mirrored(this->Mesh.point(t[1])) - a;
  const Point3 ac = this->mirrored(this->Mesh.point(t[2])) - a;
  const Point3 p = this->Mesh.point(t[1]) - this->Mesh.point(t[0]);
  const Point3 q = this->Mesh.point(t[2]) - this->Mesh.point(t[0]);
  Eigen::Matrix2d before;
  before << p.dot(p), p.dot(q), p.dot(q), q.dot(q);
  Eigen::Matrix2d after;
  after << ab.dot(ab), ab.dot(ac), ab.dot(ac), ac.dot(ac);
  if (!(before.determinant() > 0.0))
  {
    return 0.0;
  }
  // Squares of the stretches are the eigenvalues of the one metric in the other.
  const Eigen::Matrix2d ratio = before.inverse() * after;
  const double mean = 0.5 * ratio.trace();
  const double spread = std::sqrt(std::max(0.0, mean * mean - ratio.determinant()));
  const double small = std::max(mean - spread, std::exp(-2.0 * maxScale));
  return std::min(maxScale,
    0.5 * std::max(std::abs(std::log(small)), std::abs(std::log(std::max(mean + spread, small)))));
}

double IntrinsicMirror::meanStrain(Index step) const
{
  double sum = 0.0;
  double area = 0.0;
  for (Index t = 0; t < this->Mesh.triangleCount(); t += step)
  {
    sum += this->Mesh.area(t) * this->strainOf(t);
    area += this->Mesh.area(t);
  }
  return sum / area;
}
}
