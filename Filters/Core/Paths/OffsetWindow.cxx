// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/OffsetWindow.h"

#include "Base/Types.h"
#include "Paths/PathPoints.h"

#include <algorithm>

namespace flattening
{
FlatTriangle::FlatTriangle(const TriangleMesh& mesh, Index triangle)
  : Triangle(triangle)
{
  const Point3& origin = mesh.point(mesh.triangle(triangle)[0]);
  const Point3 side = mesh.point(mesh.triangle(triangle)[1]) - origin;
  const Point3 apex = mesh.point(mesh.triangle(triangle)[2]) - origin;
  const double length = side.norm();
  this->Along = side / length;
  this->Across = triangleNormal(mesh, triangle).cross(this->Along);
  this->Corners = { Point2(0.0, 0.0), Point2(length, 0.0),
    Point2(this->Along.dot(apex), this->Along.cross(apex).norm()) };
}

Point2 FlatTriangle::place(const TriangleMesh& mesh, const SurfacePoint& point) const
{
  const std::array<double, 3> weights = weightsIn(mesh, this->Triangle, point);
  return weights[0] * this->Corners[0] + weights[1] * this->Corners[1] +
    weights[2] * this->Corners[2];
}

Point2 FlatTriangle::flat(const Point3& vector) const
{
  return { this->Along.dot(vector), this->Across.dot(vector) };
}
Point3 FlatTriangle::spatial(const Point2& vector) const
{
  return vector.x() * this->Along + vector.y() * this->Across;
}

SurfacePoint FlatTriangle::pointAt(const TriangleMesh& mesh, const Point2& place, double snap) const
{
  std::array<double, 3> weights{};
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point2& from = this->Corners[(k + 1) % 3];
    weights[k] = std::max(0.0, cross(this->Corners[(k + 2) % 3] - from, place - from));
    sum += weights[k];
  }
  double kept = 0.0;
  for (double& weight : weights)
  {
    weight = weight < snap * sum ? 0.0 : weight;
    kept += weight;
  }
  for (double& weight : weights)
  {
    weight /= kept;
  }
  return pointOf(mesh, this->Triangle, weights);
}

FlatTriangle::Motion FlatTriangle::motionTo(Index k, const FlatTriangle& beyond, Index j) const
{
  const Point2 here = (this->corner(k) - this->corner(k + 1)).normalized();
  const Point2 there = (beyond.corner(j + 1) - beyond.corner(j)).normalized();
  Motion motion;
  motion.turn = Point2(here.dot(there), cross(here, there)).normalized();
  motion.shift = beyond.corner(j) - motion.direction(this->corner(k + 1));
  return motion;
}

OffsetWindow OffsetWindow::moved(const FlatTriangle::Motion& motion) const
{
  OffsetWindow window = *this;
  window.apex = motion.place(this->apex);
  window.right = motion.place(this->right);
  window.rightWay = motion.direction(this->rightWay);
  window.left = motion.place(this->left);
  window.leftWay = motion.direction(this->leftWay);
  window.normal = motion.direction(this->normal);
  return window;
}

OffsetWindow OffsetWindow::between(const Point2& rightEnd, const Point2& leftEnd) const
{
  const auto way = [this](const Point2& end) {
    return this->strip ? this->normal : Point2((end - this->apex).normalized());
  };
  OffsetWindow window = *this;
  if (this->besideRight(rightEnd) > 0.0)
  {
    window.right = rightEnd;
    window.rightWay = way(rightEnd);
  }
  if (this->besideLeft(leftEnd) > 0.0)
  {
    window.left = leftEnd;
    window.leftWay = way(leftEnd);
  }
  return window;
}

SegmentPart clipped(SegmentPart part, double atStart, double atEnd)
{
  if (atStart < 0.0 && atEnd < 0.0)
  {
    return { 1.0, 0.0 };
  }
  if (atStart < 0.0)
  {
    part.from = std::max(part.from, atStart / (atStart - atEnd));
  }
  else if (atEnd < 0.0)
  {
    part.to = std::min(part.to, atStart / (atStart - atEnd));
  }
  return part;
}
}
