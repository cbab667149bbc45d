// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/BodyContact.h"

#include "Surface/SurfacePoint.h"
#include "Surface/TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// A closest point with a smaller weight lies on the edge opposite.
constexpr double edgeWeight = 1e-9;

/// Energy an area, and its derivatives by the distance.
struct Push
{
  double value = 0.0;
  double slope = 0.0;
  double bend = 0.0;
};

Push pushAt(ContactForce force, double gap, double distance)
{
  const double inside = gap - distance;
  if (force == ContactForce::None || inside <= 0.0)
  {
    return {};
  }
  if (force == ContactForce::Penalty)
  {
    return { 0.5 * inside * inside, -inside, 1.0 };
  }
  if (distance <= 0.0)
  {
    return { std::numeric_limits<double>::infinity(), 0.0, 0.0 };
  }
  const double log = std::log(distance / gap);
  return { -inside * inside * log, 2.0 * inside * log - inside * inside / distance,
    -2.0 * log + 4.0 * inside / distance + inside * inside / (distance * distance) };
}
}

ContactBody::ContactBody(TriangleMesh mesh)
  : Mesh(std::move(mesh))
  , Locator(this->Mesh)
  , VertexNormals(vertexNormals(this->Mesh))
{
  for (Index t = 0; t < this->Mesh.triangleCount(); ++t)
  {
    this->FaceNormals.push_back(triangleNormal(this->Mesh, t));
  }
}

Point3 ContactBody::normalOf(
  Index triangle, const std::array<double, 3>& weights, bool& atBoundary) const
{
  int zeros = 0;
  int zero = 0;
  int large = 0;
  for (int k = 0; k < 3; ++k)
  {
    if (weights[k] < edgeWeight)
    {
      ++zeros;
      zero = k;
    }
    large = weights[k] > weights[large] ? k : large;
  }
  if (zeros == 0)
  {
    return this->FaceNormals[triangle];
  }
  if (zeros == 1)
  {
    const Index twin = this->Mesh.twin(3 * triangle + (zero + 1) % 3);
    atBoundary = twin == none;
    return atBoundary ? this->FaceNormals[triangle]
                      : Point3(this->FaceNormals[triangle] + this->FaceNormals[twin / 3]);
  }
  const Index vertex = this->Mesh.triangle(triangle)[large];
  atBoundary = this->Mesh.onBoundary(vertex);
  return this->VertexNormals[vertex];
}

ContactBody::Place ContactBody::locate(const Point3& point) const
{
  const ClosestPoint closest = this->Locator.closest(point);
  bool atBoundary = false;
  const Point3 normal = this->normalOf(closest.triangle, closest.weights, atBoundary);
  const Point3 from = point - closest.position;
  const double distance = from.norm();
  const double side = from.dot(normal);
  if (distance > 0.0 && (atBoundary || side >= 0.0))
  {
    return { distance, from / distance };
  }
  if (distance > 0.0)
  {
    return { -distance, -from / distance };
  }
  return { 0.0, normal.norm() > 0.0 ? Point3(normal.normalized()) : normal };
}

BodyContact::BodyContact(
  const SpaceUnknowns& unknowns, const SewnMembrane& sheet, const ContactBody* body, double gap)
  : Body(body)
  , Gap(gap)
{
  if (!body)
  {
    return;
  }
  const std::vector<double> areas = sheet.vertexAreas();
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    if (unknowns.first[v] != none)
    {
      this->Touches.push_back({ unknowns.first[v], areas[v] });
    }
  }
}

std::vector<ContactBody::Place> BodyContact::places(
  const Eigen::VectorXd& x, const Execution& execution) const
{
  std::vector<ContactBody::Place> places(this->Touches.size());
  execution.forEach(static_cast<Index>(places.size()),
    [&](Index k) { places[k] = this->Body->locate(x.segment<3>(this->Touches[k].first)); });
  return places;
}

double BodyContact::energy(const Eigen::VectorXd& x, const Execution& execution) const
{
  if (this->Force == ContactForce::None || !this->Body)
  {
    return 0.0;
  }
  double sum = 0.0;
  const std::vector<ContactBody::Place> places = this->places(x, execution);
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const double value = pushAt(this->Force, this->Gap, places[k].distance).value;
    sum += value > 0.0 ? this->Stiffness * this->Touches[k].area * value : 0.0;
  }
  return sum;
}

void BodyContact::add(const Eigen::VectorXd& x, SpaceMatrix& matrix, Eigen::VectorXd& gradient,
  const Execution& execution) const
{
  if (this->Force == ContactForce::None || !this->Body)
  {
    return;
  }
  const std::vector<ContactBody::Place> places = this->places(x, execution);
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const Push push = pushAt(this->Force, this->Gap, places[k].distance);
    if (!(push.bend > 0.0))
    {
      continue;
    }
    const double weight = this->Stiffness * this->Touches[k].area;
    const Point3& out = places[k].outwards;
    const Index first = this->Touches[k].first;
    gradient.segment<3>(first) += weight * push.slope * out;
    matrix.addOwn(first, weight * push.bend * out * out.transpose());
  }
}

double BodyContact::leastDistance(const Eigen::VectorXd& x, const Execution& execution) const
{
  double least = std::numeric_limits<double>::infinity();
  if (this->Body)
  {
    for (const ContactBody::Place& place : this->places(x, execution))
    {
      least = std::min(least, place.distance);
    }
  }
  return least;
}
}
