// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <optional>

namespace flattening::pattern
{
/// What of a flat piece must agree with its mirror image.
struct PieceShape
{
  Points2 outline;            ///< of the cloth's outer border, closed, counter-clockwise
  std::vector<Points2> lines; ///< all wires, each open or closed as it is
};

/// For each shape the earlier one whose mirror image it is, or none. Every shape belongs to one
/// pair at most. Two shapes pair if, one of them turned over and both laid on each other, no vertex
/// is farther from the other's lines than the tolerance.
std::vector<std::size_t> findMirrorPairs(const std::vector<PieceShape>& shapes, double tolerance);

/// How far mirror images may be from each other, in millimetres: less than a line of chalk is wide.
inline constexpr double mirrorTolerance = 0.5;

/// A line about which a piece is its own mirror image.
struct MirrorAxis
{
  Point2 at = Point2::Zero();
  Point2 along = Point2(0.0, 1.0); ///< of length 1, upwards
  double miss = 0.0;               ///< how far a vertex is from the mirror image
};

/// The axis of a symmetric shape, the most upright where there are several; none where a vertex is
/// farther from the mirror image than the tolerance.
std::optional<MirrorAxis> findMirrorAxis(const PieceShape& shape, double tolerance);

/// The same, or where there is none the one about which it misses its mirror image least.
MirrorAxis nearestMirrorAxis(const PieceShape& shape, double tolerance);

Point2 imageOf(const Point2& p, const MirrorAxis& axis);

/// How far a vertex of a shape, mirrored at the axis, is from its lines.
double mirrorMiss(const PieceShape& shape, const MirrorAxis& axis);

inline constexpr std::size_t noPair = static_cast<std::size_t>(-1);
}
