// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Base/Types.h"
#include "Surface/TriangleMesh.h"

#include <cmath>
#include <vector>

namespace flattening
{
/// Coordinates beyond it, and triangles smaller than one by it, are refused: squares of areas and
/// what is summed of them would over- or underflow.
inline constexpr double largestCoordinate = 1e60;

inline bool isUsable(double x)
{
  return std::isfinite(x) && std::abs(x) <= largestCoordinate;
}

/// Raises no floating-point exception, unlike a comparison with a NaN.
inline bool isUsable(const Point3& p)
{
  return isUsable(p.x()) && isUsable(p.y()) && isUsable(p.z());
}

/// A surface as it came in, made into a mesh or refused.
struct PreparedSurface
{
  /// Triangle k is the k-th triangle of the input; its corners may be reversed (see below).
  TriangleMesh mesh;
  /// Per mesh vertex the first input point that became it.
  Indices originalPoint;
  /// Per input point its mesh vertex; none for a point that no triangle uses.
  Indices vertexOfPoint;
  /// Triangles that were turned over to agree with the majority of their component.
  Indices reversedTriangles;
  Status status;
};

/// Height over longest edge up to which a triangle has no area in double precision.
inline constexpr double flatTriangle = 1e-12;

enum class CoincidentPoints
{
  /// Joined where the triangles are separate, each or two by two with points of their own (as STL
  /// has them); else kept, because the edges of a surface may meet in space without being sewn.
  Automatic,
  Join, ///< points with equal coordinates are one
  Keep, ///< each point is a vertex of its own: a surface that is cut open stays so
};

inline bool repeatsCorner(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Whether a triangle has a height below flatTriangle of its longest edge, or no size.
bool hasNoArea(const Points3& points, const Triangle& t);

/// Triangles that have the same corners as an earlier one, in either orientation, ascending.
/// \param sides as sorted. Two of them share edges, and the corner opposite to each.
Indices doubledTriangles(const Triangles& triangles, const std::vector<HalfedgeKey>& sides);

/// The refusal of an edge between two points that more than two triangles have.
Status crowdedEdge(Index low, Index high, const Indices& triangles);

/// Per point the first one of those in its place that are to be one; of points that no triangle
/// uses themselves.
Indices firstInPlace(
  const Points3& points, const Triangles& triangles, CoincidentPoints coincident);

/// Joins coincident points as asked, orients triangles consistently, and checks that the result
/// is a manifold surface of finite coordinates and of triangles with area.
///
/// Errors (ids): EmptySurface; InvalidPointId (triangles); NonFinitePoint (points);
/// DegenerateTriangle (triangles whose height is below flatTriangle of their longest edge, or with
/// a corner twice); NonManifoldEdge (the triangles at one edge, or those that have the same corners
/// as another); NonManifoldVertex (points); NotOrientable (triangles along a one-sided band). Ids
/// are those of the input.
PreparedSurface prepareSurface(const Points3& points, const Triangles& triangles,
  CoincidentPoints coincident = CoincidentPoints::Automatic);
}
