// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{
/// Where the area of a surface lies.
struct SurfaceMoments
{
  double area = 0.0;
  Point3 center = Point3::Zero();
  /// Of unit length, in columns: from the one along which the surface extends least.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

SurfaceMoments momentsOf(const TriangleMesh& mesh);
}
