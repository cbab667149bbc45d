// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

namespace flattening
{
/// Index of a vertex, triangle, half-edge, node, curve ...; -1 means "none".
using Index = std::int32_t;

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;
using Points2 = std::vector<Point2>;
using Points3 = std::vector<Point3>;
using Indices = std::vector<Index>;
using Triangle = std::array<Index, 3>;
using Triangles = std::vector<Triangle>;

inline constexpr Index none = -1;
inline constexpr double pi = 3.141592653589793238462643383279502884;
/// The larger part of a golden section.
inline constexpr double goldenRatio = 0.618033988749894848204586834365638118;
inline constexpr double degree = pi / 180.0; ///< in radians
}
