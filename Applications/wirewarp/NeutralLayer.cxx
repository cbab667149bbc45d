// SPDX-License-Identifier: BSD-3-Clause
#include "NeutralLayer.h"

#include "TriangleList.h"

#include <vtkNew.h>
#include <vtkPoints.h>

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

namespace wirewarp
{
namespace
{
/// The least move of a point that takes all planes around it along by a distance, or nearly where
/// no move does.
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
  return move;
}
}

vtkSmartPointer<vtkPolyData> neutralLayer(vtkPolyData* surface, double inwards)
{
  const TriangleList list = listTriangles(surface);
  const auto at = [&list](vtkIdType point) {
    return Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(list.points->GetPoint(point)));
  };
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  std::vector<Eigen::Matrix3d> planes(count, Eigen::Matrix3d::Zero());
  std::vector<Eigen::Vector3d> normals(count, Eigen::Vector3d::Zero());
  for (const ListedTriangle& triangle : list.triangles)
  {
    const Eigen::Vector3d first = at(triangle.corners[0]);
    const Eigen::Vector3d twice =
      (at(triangle.corners[1]) - first).cross(at(triangle.corners[2]) - first);
    const double area = twice.norm();
    for (std::size_t k = 0; k < 3 && area > 0.0; ++k)
    {
      const auto point = static_cast<std::size_t>(triangle.corners[k]);
      planes[point] += twice * twice.transpose() / area;
      normals[point] += twice;
    }
  }
  const vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  moved->DeepCopy(surface->GetPoints());
  for (std::size_t k = 0; k < count; ++k)
  {
    if (normals[k].squaredNorm() > 0.0)
    {
      const auto point = static_cast<vtkIdType>(k);
      const Eigen::Vector3d place = at(point) + moveOf(planes[k], normals[k], -inwards);
      moved->SetPoint(point, place.data());
    }
  }
  auto layer = vtkSmartPointer<vtkPolyData>::New();
  layer->ShallowCopy(surface);
  layer->SetPoints(moved);
  return layer;
}
}
