// SPDX-License-Identifier: BSD-3-Clause
#include "NeutralLayer.h"

#include "TriangleList.h"

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace wirewarp
{
namespace
{
/// The least move of a point that takes all planes around it along by a distance, or nearly where
/// no move does; at sharp edges, where it would be far beyond them, of at most twice the distance.
Eigen::Vector3d moveOf(const Eigen::Matrix3d& planes, const Eigen::Vector3d& normals, double by)
{
  constexpr double leastShare = 1e-6; // of rounding, where planes are parallel
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(planes);
  Eigen::Vector3d move = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d axis = axes.eigenvectors().col(k);
    if (axes.eigenvalues()[k] > leastShare * axes.eigenvalues()[2])
    {
      move += by * axis.dot(normals) / axes.eigenvalues()[k] * axis;
    }
  }
  const double largest = 2.0 * std::abs(by);
  const double length = move.norm();
  return length > largest ? Eigen::Vector3d(largest / length * move) : move;
}
}

DataSet neutralLayer(const DataSet& surface, double inwards)
{
  const TriangleList list = listTriangles(surface);
  const Points3& points = *surface.points;
  const std::size_t count = points.size();
  std::vector<Eigen::Matrix3d> planes(count, Eigen::Matrix3d::Zero());
  std::vector<Eigen::Vector3d> normals(count, Eigen::Vector3d::Zero());
  for (const ListedTriangle& triangle : list.triangles)
  {
    const Eigen::Vector3d& first = list.point(triangle.corners[0]);
    const Eigen::Vector3d twice =
      (list.point(triangle.corners[1]) - first).cross(list.point(triangle.corners[2]) - first);
    const double area = twice.norm();
    for (std::size_t k = 0; k < 3 && area > 0.0; ++k)
    {
      const auto point = static_cast<std::size_t>(triangle.corners[k]);
      planes[point] += twice * twice.transpose() / area;
      normals[point] += twice;
    }
  }
  Points3 moved = points;
  for (std::size_t k = 0; k < count; ++k)
  {
    if (normals[k].squaredNorm() > 0.0)
    {
      moved[k] += moveOf(planes[k], normals[k], -inwards);
    }
  }
  DataSet layer = surface;
  layer.points = std::make_shared<const Points3>(std::move(moved));
  return layer;
}
}
