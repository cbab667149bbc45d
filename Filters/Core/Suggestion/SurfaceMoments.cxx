// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SurfaceMoments.h"

#include <Eigen/Eigenvalues>

namespace flattening
{
SurfaceMoments momentsOf(const TriangleMesh& mesh)
{
  SurfaceMoments moments;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const double area = mesh.area(t);
    for (int k = 0; k < 3; ++k)
    {
      // The edges' middles integrate polynomials of degree 2 exactly.
      const Point3 middle =
        0.5 * (mesh.point(mesh.triangle(t)[k]) + mesh.point(mesh.triangle(t)[(k + 1) % 3]));
      moments.center += area / 3.0 * middle;
      second += area / 3.0 * middle * middle.transpose();
    }
    moments.area += area;
  }
  moments.center /= moments.area;
  second = second / moments.area - moments.center * moments.center.transpose();
  moments.axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(second).eigenvectors();
  return moments;
}
}
