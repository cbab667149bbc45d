// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/IntrinsicMirror.h"

#include "Cut/PieceTopology.h"
#include "Embedding/ConvexEmbedding.h"
#include "Suggestion/BoundarySymmetry.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// No triangle counts for more.
constexpr double mostScale = 1.0;
/// Axes are compared by about so many triangles.
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
  if (turns.empty())
  {
    return nullptr;
  }
  const Points2 flat = embedConvexly(mesh, execution);
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
  const double small = std::max(mean - spread, std::exp(-2.0 * mostScale));
  return std::min(mostScale,
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
