// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/StraightPath.h"
#include "Surface/SurfacePoint.h"
#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// A place of a path.
struct PathFoot
{
  std::size_t segment = 0;
  double along = 0.0; ///< fraction of the segment
  double gap = 0.0;   ///< in space, to a point
};
/// On one segment, the place that is nearest in space.
PathFoot footOnSegment(const SurfacePath& path, std::size_t segment, const Point3& point);
/// How far a point is from a path in space. No way over the surface is shorter.
double gapInSpace(const SurfacePath& path, const Point3& point);

/// The shortest straight path from a path to a point, and on which side it leaves.
struct PathDistance
{
  StraightPath way; ///< from the path to the point
  bool left = false;
};

/// Where several parts of the path are near, each is looked at. Errors: as of straightPath().
PathDistance distanceFrom(
  const PathGraph& graph, const SurfacePath& path, const SurfacePoint& point);

/// Directions at a point between two, in one triangle, anti-clockwise.
struct DirectionRange
{
  Index triangle = none;
  Point3 first = Point3::Zero(); ///< of length 1
  Point3 last = Point3::Zero();
  double begin = 0.0; ///< angle of the first
};

/// The directions at a point of a surface by their angles, as the triangles around the point lie
/// when they are unfolded one after the other, anti-clockwise.
class PointDirections
{
public:
  /// \pre The point lies on the mesh.
  PointDirections(const TriangleMesh& mesh, const SurfacePoint& point);

  /// The angle all around: 2 pi in triangles and on edges, half of it on the boundary's.
  double total() const;
  /// At the boundary angles run from 0 to total(), elsewhere around.
  bool atBoundary() const { return this->Boundary; }
  /// The angle towards another point of a triangle around.
  double angleTo(Index triangle, const Point3& target) const;
  /// All directions from one angle to a greater one, triangle by triangle.
  std::vector<DirectionRange> between(double first, double last) const;

private:
  struct Sector
  {
    Index triangle = none;
    Point3 first = Point3::Zero();  ///< where the sector starts
    Point3 across = Point3::Zero(); ///< a quarter turn on from there
    double begin = 0.0;
    double size = 0.0;

    Point3 at(double angle) const;
  };
  /// The triangle of a half-edge, from its direction on.
  void add(const TriangleMesh& mesh, Index h, double size);

  Point3 Apex;
  std::vector<Sector> Sectors;
  bool Boundary = false;
};
}
